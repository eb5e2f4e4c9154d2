// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/library/records/study_record.h"
#include "core/quality/plan/study_plan.h"

#include <QDate>

namespace gripscope {

/// As CalibrationStatus; NotAsked: it was made once, and was not to be repeated.
enum class StudyStatus { NotAsked, Missing, Valid, DueSoon, Overdue };

/// Where a gripper stands with one kind of study.
struct StudyStanding {
    StudyKind kind = StudyKind::Gauge;
    std::optional<StudyRecord> last; ///< finished last
    std::optional<QDate> due;        ///< the last day it holds; nothing: for ever, or there is none

    /// Due soon is what it is for a calibration (dueSoonDays).
    [[nodiscard]] StudyStatus status(const QDate& today) const;
};

/// The kinds in the order of practice: type-1, gauge, linearity, attributes.
[[nodiscard]] std::vector<StudyKind> studyKindsInOrder();

/// The last day on which a finished study holds: so many months after it ended as were decided when it was
/// begun (StudyOptions::repeatAfterMonths), by the calendar of this place. Nothing where it is not to be
/// repeated, or has no result.
[[nodiscard]] std::optional<QDate> studyHoldsUntil(const StudyRecord& study);

/// Of each kind, in the order of practice. `studies` newest first, of all grippers; those of the gripper with
/// this serial number count, of any where it is empty. People who judge parts do so without a gripper:
/// attribute agreement counts wherever it was made.
[[nodiscard]] std::vector<StudyStanding> studyStandings(const std::vector<StudyRecord>& studies,
                                                        const QString& gripperSerial);

} // namespace gripscope
