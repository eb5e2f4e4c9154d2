// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/calibrate_session.h"

#include <QWidget>

class QDateEdit;
class QDoubleSpinBox;
class QGridLayout;
class QLabel;
class QLineEdit;
class QProgressBar;
class QPushButton;
class QSpinBox;
class QStackedWidget;
class QTableView;

namespace gripscope {

class CalibrationPlot;
class CalibrationPointsModel;
class Workbench;

/// A calibration under way: which load comes next, what the channel says, the points so far with what is left
/// of them, and in the end the figures and the decision.
class CalibrateTaking : public QWidget {
    Q_OBJECT
public:
    CalibrateTaking(Workbench& workbench, CalibrateSession& session, QWidget* parent = nullptr);
    ~CalibrateTaking() override;
    void refresh();        ///< after the session changed
    void refreshReading(); ///< the number that the channel says now
    void takeOrAccept();   ///< what Space does
    void undo();           ///< what Backspace does

signals:
    void abandoned();

private:
    QWidget* makePlots();
    QWidget* makeSide();
    QWidget* makeNext();
    QWidget* makeDecision();
    void take();
    void accept();
    void showPoints();
    void showNext();
    void showLoad(const PlannedPoint& next);
    void showFigures();
    [[nodiscard]] static QString instruction(const PlannedPoint& next, const CalibrationPlan& plan);
    [[nodiscard]] std::vector<double> recentValues() const; ///< of the channel, evenly spaced in time
    [[nodiscard]] QString shown(double value, int digits) const;

    Workbench* m_workbench;
    CalibrateSession* m_session;
    CalibrationPlot* m_plot;
    CalibrationPointsModel* m_model;
    QTableView* m_table;
    QStackedWidget* m_stack;
    QLabel *m_title, *m_step, *m_load, *m_way, *m_reading, *m_steady, *m_words;
    QWidget* m_shownBox;        ///< what a load cell shows
    QDoubleSpinBox* m_onIt;     ///< in the unit of m_load
    double m_perChannel = 1;    ///< that unit's number for one of the channel's
    std::size_t m_proposed = 0; ///< points there were when a load was proposed, and one
    QProgressBar* m_progress;
    QPushButton *m_take, *m_undo, *m_abandon, *m_accept;
    QGridLayout* m_figures;
    QLabel* m_doubt;
    QSpinBox* m_degree;
    QDateEdit* m_due;
    QLineEdit* m_note;
};

} // namespace gripscope
