// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/display_units.h"
#include "core/calibration/calibration_plan.h"
#include "core/session/calibrate/calibrate_session.h"
#include "ui/windows/dialog.h"

#include <QWidget>

#include <optional>

class QCheckBox;
class QComboBox;
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
class QuantityBox;
class QuantityListEdit;
class Workbench;

/// What a certificate says that the points do not.
struct CertificateDetails {
    QDate referenceDue; ///< invalid: nobody said
    std::optional<double> ambient_C;
    std::optional<double> tolerance_si;
    DecisionRule rule = DecisionRule::Guarded;
    bool checkAfter = false;
};

/// Asks for it before the first load is put on. What is not ticked is not stated.
class CertificateDialog : public Dialog {
    Q_OBJECT
public:
    CertificateDialog(const CertificateDetails& details, SensorChannel channel, QWidget* parent = nullptr);
    [[nodiscard]] CertificateDetails details() const;

private:
    void build();
    void addRow(QGridLayout* grid, QCheckBox* stated, QWidget* field);
    void show(const CertificateDetails& details);

    QCheckBox *m_hasDue, *m_hasAmbient, *m_hasTolerance, *m_checkAfter;
    QDateEdit* m_due;
    QDoubleSpinBox* m_ambient;
    QuantityBox* m_tolerance;
    QComboBox* m_rule;
};

/// What a calibration is to be: the channel, the loads, how often, against what. Says at once what is wrong.
class CalibrateSetup : public QWidget {
    Q_OBJECT
public:
    explicit CalibrateSetup(Workbench& workbench, QWidget* parent = nullptr);
    [[nodiscard]] CalibrationPlan plan() const; ///< loads in the channel's unit

signals:
    void begun(const gripscope::CalibrationPlan& plan);

private:
    void build();
    void proposeLoads();
    void validate();
    void askInUnit();
    void takeGravity();
    enum class Way { Weights, LoadCell, GaugeBlocks, Kilograms, Pounds };
    [[nodiscard]] Way way() const;
    [[nodiscard]] SensorChannel channel() const;
    [[nodiscard]] LoadUnit loadUnit() const;
    void askForDetails();
    [[nodiscard]] CalibrationPlan withDetails(CalibrationPlan plan) const;
    /// N or mm, or what the person reads in their place; that of the masses.
    [[nodiscard]] ShownUnit typedUnit() const;
    [[nodiscard]] double siPerChannel() const;
    [[nodiscard]] QString problem() const;

    Workbench* m_workbench;
    QComboBox* m_channel;
    QLabel* m_loadsName = nullptr;
    QuantityListEdit* m_loads;
    QSpinBox* m_runs;
    QCheckBox* m_descending;
    QSpinBox* m_degree;
    QLineEdit* m_reference;
    QLineEdit* m_certificate;
    QuantityBox* m_uncertainty;
    QString m_askedIn; ///< the unit of the fields
    QLabel* m_summary;
    QPushButton* m_begin;
    CertificateDetails m_details;
    SensorChannel m_detailsOf = SensorChannel::Force; ///< the channel of the tolerance in them
};

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
