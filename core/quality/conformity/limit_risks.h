// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/quality/conformity/conformity.h"

#include <vector>

namespace gripscope {

/// What limits on one quantity risk, by squeezes of the type that are there.
struct QuantityRisks {
    int squeezes = 0;
    double mean = 0;
    double deviation = 0; ///< of the parts
    /// Of the squeezes: what they show does not exceed what they are uncertain by, so that how far the parts
    /// themselves differ is not told; `deviation` is then that of the squeezes, which is the larger.
    bool deviationIsOfSqueezes = false;
    double uncertainty = 0; ///< standard, of a typical squeeze: the root of the mean square
    double guard = 0;       ///< of the rule at that uncertainty
    GlobalRisks risks = {};
    /// The guard band that leaves a consumer's risk of a tenth of a percent (any rule); nothing: none needed,
    /// or none will do.
    std::optional<double> guardForSmallRisk = {};
};
using LimitRisks = std::array<std::optional<QuantityRisks>, 3>; ///< of m, b, k
inline constexpr int fewestForRisks = 3;
inline constexpr double smallConsumersRisk = 0.001;

/// Of m, b, k: those that have limits, and `fewestForRisks` squeezes with a known uncertainty that are not
/// all alike. With s^2 the variance of their values and u^2 the mean of their squared uncertainties the parts
/// vary by s^2 - u^2 (components of variance). Accepted is what the rule says conforms, so that what is too
/// near the limit counts as rejected: the producer's risk holds it. `squeezes`: in the units of the limits.
/// Error: that of PartLimits::validate().
[[nodiscard]] Expected<LimitRisks> limitRisks(const PartLimits& limits,
                                              const std::vector<MeasuredValues>& squeezes);

} // namespace gripscope
