// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/quality/drift.h"

#include <QCoreApplication>

namespace gripscope {

/// What moved, and what to do about it, for whoever answers for the gripper.
class ShiftWords {
    Q_DECLARE_TR_FUNCTIONS(ShiftWords)
public:
    /// "The force or position sensor": a heading.
    [[nodiscard]] static QString cause(DriftCause cause);
    /// What to do next, a sentence; empty where there is nothing to do.
    [[nodiscard]] static QString nextStep(const DriftReport& report, const QString& batch);
    /// The page where that is done, and what its button says; empty where there is nothing to do.
    [[nodiscard]] static QString nextPage(DriftCause cause);
    [[nodiscard]] static QString nextButton(DriftCause cause);
    /// "+2.1 % (1.6 to 2.6)" of a difference of logarithms and its standard uncertainty, 95 %.
    [[nodiscard]] static QString percentInterval(double log, double deviation);
    /// "Mass m", "Damping b", "Stiffness k"
    [[nodiscard]] static QString quantity(std::size_t place);
};

/// exp(log) - 1 in percent at log and at log -+ 1.96 u.
struct PercentInterval {
    double value = 0, low = 0, high = 0;
};
[[nodiscard]] PercentInterval percentIntervalOf(double log, double deviation);

} // namespace gripscope
