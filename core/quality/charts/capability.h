// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/math/two_sided_interval.h"
#include "core/quality/charts/subgroups.h"
#include "core/quality/charts/within_spread.h"
#include "core/quality/limits/tolerance_limits.h"

#include <optional>
#include <span>

namespace gripscope {

struct NormalityTest {
    double statistic = 0; ///< A^2
    double adjusted = 0;  ///< A^2 (1 + 0.75/n + 2.25/n^2)
    double p = 1;         ///< not below 3.7e-24, where the formula ends
};

/// Anderson and Darling's test of normal values, mean and standard deviation from the values:
///     A^2 = -n - (1/n) sum (2i - 1) [log Phi(z_i) + log(1 - Phi(z_(n+1-i)))],  z sorted,
/// and p by the formula of D'Agostino and Stephens (Goodness-of-Fit Techniques, 1986, table 4.9). Assumes
/// independent values. BadInput: fewer than 8 values, or values that do not vary.
[[nodiscard]] Expected<NormalityTest> testNormality(std::span<const double> values);
/// The same of values that are sorted already, ascending, and their summary.
[[nodiscard]] Expected<NormalityTest> testNormality(std::span<const double> sorted,
                                                    const SubgroupSummary& summary);

struct CapabilityOptions {
    ToleranceLimits limits;
    std::optional<double> target; ///< of Cpm; absent: the middle of two limits
    SpreadMethod within = SpreadMethod::Automatic;
    double confidence = 0.95;
};

struct CapabilityIndex {
    double value = 0;
    TwoSidedInterval interval;
};

/// Indices by one sigma. Cp and Pp, Cpk and Ppk are the same formulas by the two.
struct CapabilityIndices {
    double sigma = 0;
    double degreesOfFreedom = 0;           ///< that the intervals go by
    std::optional<CapabilityIndex> spread; ///< Cp: (U - L)/(6 sigma); two limits only
    CapabilityIndex nearest;               ///< Cpk: of the nearer limit, |limit - mean|/(3 sigma)
    std::optional<double> lower, upper;    ///< of each limit
    double expectedPpm = 0;                ///< parts per million beyond the limits, were the values normal
};

struct Capability {
    std::size_t count = 0;
    double mean = 0;
    CapabilityIndices within;  ///< intervals by n - 1 degrees of freedom, as published ones are
    CapabilityIndices overall; ///< the same of the deviation of all values
    /// `within` with what its sigma is worth: fewer degrees of freedom for ranges, n - subgroups for pooled.
    /// These are the intervals that cover the truth as often as stated.
    CapabilityIndices withinByEstimator;
    WithinSpread spread;
    std::optional<CapabilityIndex> target;  ///< Cpm
    std::optional<NormalityTest> normality; ///< absent for too few values
    double observedPpm = 0;
    Findings messages;
};

/// Process capability of normal values against limits L and U, with mean x:
///     Cp = (U - L)/(6 s),  Cpk = min(U - x, x - L)/(3 s),  Cpm = (U - L)/(6 sqrt(s^2 + (x - T)^2)),
/// s within subgroups (withinSpread()) or overall (n - 1; Pp, Ppk and Cpm). Intervals, two-sided:
///     Cp:  Cp sqrt(chi^2_(a/2)(nu)/nu) to Cp sqrt(chi^2_(1-a/2)(nu)/nu)
///     Cpk: Cpk (1 +- z sqrt(1/(9 n Cpk^2) + 1/(2 nu)))  (Bissell, How reliable is your capability index?,
///          Applied Statistics 1990)
///     Cpm: as Cp with nu = n (1 + e^2)^2/(1 + 2 e^2), e = (x - T)/s  (Boyles, The Taguchi capability index,
///          Journal of Quality Technology 1991)
/// With one limit there is no Cp, and Cpk is of that one. Assumes a stable process and independent normal
/// values; the test of that is in the result, and what to do where it fails in box_cox.h and
/// percentile_capability.h. Usage: limits, confidence outside (0, 1). BadInput: as withinSpread().
[[nodiscard]] Expected<Capability> studyCapability(const Subgroups& groups, const CapabilityOptions& options);
/// The same where its values are sorted already, ascending.
[[nodiscard]] Expected<Capability> studyCapability(const Subgroups& groups, std::span<const double> sorted,
                                                   const CapabilityOptions& options);

/// By a mean and a sigma that are known from elsewhere; `count` values and `degreesOfFreedom` behind them.
/// Limits that are valid, sigma above 0.
[[nodiscard]] CapabilityIndices capabilityIndices(double mean, double sigma, double count,
                                                  double degreesOfFreedom, const CapabilityOptions& options);

/// "Not capable: ..." with what to do: by the index and by the lower end of its interval, against 1.33.
[[nodiscard]] Finding capabilityVerdict(const CapabilityIndex& nearest);

} // namespace gripscope
