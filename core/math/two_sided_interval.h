// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace gripscope {

/// Confidence limits, with the same chance of error beyond each.
struct TwoSidedInterval {
    double lower = 0, upper = 0;
};

/// Of an index c / sigma whose sigma was estimated with so many degrees of freedom nu (above 0) from normal
/// values, nu s^2 / sigma^2 being chi-square: index sqrt(chi^2_lower / nu) to index sqrt(chi^2_upper / nu).
/// `confidence` between 0 and 1.
[[nodiscard]] TwoSidedInterval intervalOverDeviation(double index, double degreesOfFreedom,
                                                     double confidence);

} // namespace gripscope
