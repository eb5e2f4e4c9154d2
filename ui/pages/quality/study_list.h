// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/library/records/study_record.h"
#include "core/quality/plan/study_plan.h"
#include "core/session/quality/study_due.h"

#include <QWidget>

#include <vector>

class QLabel;
class QVBoxLayout;

namespace gripscope {

class Workbench;

/// All studies of the library: those that are not finished first, then what can be begun, in the order of
/// practice, then what was found before.
class StudyList : public QWidget {
    Q_OBJECT
public:
    explicit StudyList(Workbench& workbench, QWidget* parent = nullptr);
    void load(); ///< asks the library
    /// Newest first, as the library had them when it was last asked.
    [[nodiscard]] const std::vector<StudyRecord>& studies() const { return m_studies; }

signals:
    void beginAsked(gripscope::StudyKind kind);
    void driftAsked();                      ///< what has moved
    void transferAsked();                   ///< types on another gripper
    void openAsked(const QString& studyId); ///< to go on with, or to read
    void processAsked();                    ///< control charts and capability

private:
    void show(std::vector<StudyRecord> studies);
    [[nodiscard]] QWidget* makeKinds();
    [[nodiscard]] QWidget* makeKind(int number, const QString& name, const QString& answer,
                                    const QString& state, QWidget* button);
    [[nodiscard]] QWidget* makeStudy(const StudyRecord& study);
    void fillKinds();
    void fillStudies();
    [[nodiscard]] QString standing(const StudyStanding& standing) const;
    [[nodiscard]] static QString finished(const StudyRecord& last, StudyKind kind);
    [[nodiscard]] QString transferStanding() const;
    [[nodiscard]] QString advice() const;

    Workbench* m_workbench;
    std::vector<StudyRecord> m_studies;
    QString m_serial; ///< of the gripper whose standing is shown; empty: of any
    QLabel* m_advice;
    QWidget *m_open, *m_kinds, *m_done;
    QVBoxLayout *m_openRows, *m_kindRows, *m_doneRows;
};

} // namespace gripscope
