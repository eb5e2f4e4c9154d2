// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/uncertainty/uncertainty_budget.h"

#include <QString>

#include <optional>
#include <vector>

namespace gripscope {

/// A quantity that follows from m, b and k, with its uncertainty.
struct DerivedQuantity {
    QString id;                  ///< natural_frequency, damping_ratio, ... (derivedQuantities)
    Finding name;                ///< "natural frequency"
    QString unit;                ///< "Hz"
    std::optional<double> value; ///< none: the record does not tell; `words` say what it does tell
    CombinedUncertainty uncertainty;
    CoverageInterval interval;
    Finding words; ///< empty when there is nothing to say beyond the numbers
};

/// What m, b and k of a budget mean, all uncertainties propagated from its combined covariance to first
/// order, intervals in the logarithm (JCGM 100, 5.1; all are positive):
/// - natural_frequency f = sqrt(k/m) / 2 pi, Hz; damping_ratio zeta = b / (2 sqrt(k m));
/// - underdamped: damped_frequency f sqrt(1 - zeta^2), Hz, and decay_time 2m/b, s, in which the swing falls
/// to
///   1/e;
/// - overdamped: time_constant_slow (b + D) / 2k and time_constant_fast 2m / (b + D), D^2 = b^2 - 4mk;
/// - damping within two standard uncertainties of critical: one time_constant sqrt(m/k), since the two cannot
///   be told apart.
/// All are the same in any consistent units of the channels. A quantity whose relative standard uncertainty
/// is above 50 % has words in place of a value. Empty without parameters above zero.
[[nodiscard]] std::vector<DerivedQuantity> derivedFrom(const UncertaintyBudget& budget);

} // namespace gripscope
