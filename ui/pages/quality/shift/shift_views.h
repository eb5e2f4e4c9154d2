// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/quality/study_session.h"
#include "core/session/shift/drift_look.h"
#include "core/session/shift/transfer_watch.h"

#include <QMap>
#include <QWidget>

#include <optional>

class QComboBox;
class QLabel;
class QPushButton;
class QStackedWidget;
class QTabBar;
class QTableWidget;

namespace gripscope {

class CoursePlot;
class IntervalPlot;
class TransferLead;
class TransferOutcome;
class TransferStart;
class Workbench;

/// What has moved since the enrolment: which part of the gripper or which product, since when, how sure, and
/// what to do next, with the way there. Read and worked out behind the screen.
class DriftView : public QWidget {
    Q_OBJECT
public:
    explicit DriftView(Workbench& workbench, QWidget* parent = nullptr);
    void load(); ///< asks the library for what is chosen
    void focusFirst();
    /// Of the last answer; nothing before, and where the library gave none.
    [[nodiscard]] const std::optional<DriftLook>& look() const { return m_look; }

signals:
    void left(); ///< back to the list

private:
    [[nodiscard]] QWidget* makeHead();
    [[nodiscard]] QWidget* makeVerdict(QWidget* parent);
    [[nodiscard]] QWidget* makeCourse(QWidget* parent);
    [[nodiscard]] QWidget* makeTable(QWidget* parent);
    [[nodiscard]] InspectedChoice choice() const;
    void show(const Expected<DriftLook>& look);
    void showVerdict();
    void showCourse();
    void showTable();
    void offer(QComboBox* box, const QStringList& names);
    [[nodiscard]] QMap<QString, int> places() const; ///< colours of the types

    Workbench* m_workbench;
    QComboBox *m_newest, *m_gripper, *m_station;
    QLabel *m_cause, *m_words, *m_since, *m_next, *m_counts;
    QPushButton* m_go;
    QTabBar* m_tabs;
    IntervalPlot* m_shifts;
    CoursePlot* m_course;
    QTableWidget* m_table;
    QWidget* m_figures;
    int m_asked = 0; ///< the last request; answers to others are dropped
    std::optional<DriftLook> m_look;
};

/// Types on another gripper: the choice of types, the squeezes, the adjustment; shown is what the study
/// session has, and the choice where it has no transfer.
class TransferView : public QWidget {
    Q_OBJECT
public:
    explicit TransferView(Workbench& workbench, QWidget* parent = nullptr);
    void begin();   ///< the choice, anew
    void refresh(); ///< the session, or the connection, has changed
    void focusFirst();
    void act(); ///< Space
    void undo();
    [[nodiscard]] const TransferWatch& watch() const { return m_watch; }

signals:
    void left();
    void submitted(const gripscope::StudyRequest& request);

private:
    void poll();
    void showStep();

    Workbench* m_workbench;
    TransferWatch m_watch;
    QStackedWidget* m_stack;
    TransferStart* m_start;
    TransferLead* m_lead;
    TransferOutcome* m_outcome;
    QString m_ended; ///< the study whose outcome is shown
};

} // namespace gripscope
