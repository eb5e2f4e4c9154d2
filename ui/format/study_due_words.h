// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/quality/study_due.h"

#include <QCoreApplication>

#include <vector>

namespace gripscope {

/// When studies of a gripper are due again, in words, as CalibrationWords has it for its sensors.
class StudyDueWords {
    Q_DECLARE_TR_FUNCTIONS(StudyDueWords)
public:
    [[nodiscard]] static QString name(StudyKind kind); ///< "Gauge study"
    /// "holds until 1 Mar 2027", "overdue since 1 Mar 2026", "due"; `asked`: a kind that was never made is
    /// to be.
    [[nodiscard]] static QString status(const StudyStanding& standing, const QDate& today, bool asked = true);
    /// For the status line, of what is due first: "gauge study due in 41 days"; empty where no study was
    /// made that is to be repeated.
    [[nodiscard]] static QString brief(const std::vector<StudyStanding>& standings, const QDate& today);
    /// Beside the calibrations, a line each of what was made: "Gauge study: holds until 1 Mar 2027."; else
    /// that there is none.
    [[nodiscard]] static QString lines(const std::vector<StudyStanding>& standings, const QDate& today);
};

} // namespace gripscope
