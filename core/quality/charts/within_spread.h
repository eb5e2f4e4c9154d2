// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/quality/charts/subgroups.h"

namespace gripscope {

enum class SpreadMethod {
    Automatic,   ///< moving ranges of individuals, ranges of at most 10 values, else deviations
    MovingRange, ///< mean |x_i - x_(i-1)| / d2(2)
    Range,       ///< ranges / d2
    Deviation,   ///< standard deviations / c4
    Pooled,      ///< sqrt(sum (n_i - 1) s_i^2 / sum (n_i - 1))
};
[[nodiscard]] QString toString(SpreadMethod method); ///< "moving_range", "range", "deviation", "pooled"

/// The standard deviation of a process as it shows within subgroups.
struct WithinSpread {
    SpreadMethod method = SpreadMethod::Pooled; ///< never Automatic
    double sigma = 0;
    /// sigma x `chiFactor` varies as true sigma x chi / sqrt(nu) with nu `degreesOfFreedom`, which need not
    /// be whole: what an interval for sigma goes by.
    double degreesOfFreedom = 0, chiFactor = 1;
    std::size_t singles = 0; ///< subgroups of one, which say nothing of it
};

/// Subgroups of unequal size are weighted by what they know (minimum variance, linear and unbiased): ranges
/// d2_i^2/d3_i^2, deviations c4_i^2/(1 - c4_i^2) (Burr, Control charts for measurements with varying sample
/// sizes, Journal of Quality Technology 1969). Degrees of freedom: equivalentDegrees() of the estimate's
/// variance; of moving ranges with the covariance of neighbours,
///     E|A||B| = (4/pi) (sqrt(3)/2 + pi/12) for differences of neighbours (correlation -1/2).
/// Assumes independent normal values. BadInput: fewer than two individuals, no subgroup of two, moving ranges
/// of subgroups, and values that do not vary (sigma 0).
[[nodiscard]] Expected<WithinSpread> withinSpread(const Subgroups& groups, SpreadMethod method);

} // namespace gripscope
