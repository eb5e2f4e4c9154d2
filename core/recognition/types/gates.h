// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

namespace gripscope {

// How far from its type a squeeze may lie, as squared distances in p dimensions.

/// Quantile 1 - rate of d' V^-1 d where V is estimated with so many degrees of freedom and d ~ N(0, V):
///     p v/(v-p+1) F(1 - rate; p, v-p+1),   for p = 3   3 v/(v-2) F(1 - rate; 3, v-2).
/// Holds on average over enrolments. Nothing while v < p, or where it is beyond all numbers. (Anderson, An
/// Introduction to Multivariate Statistical Analysis, 5.2.)
[[nodiscard]] std::optional<double> predictiveGate(double degreesOfFreedom, double rate, int dimensions = 3);

/// The inverse: the probability that d' V^-1 d is larger by chance; 0 beyond all numbers. `count`: of so many
/// independent components, each estimated like one of the p; absent: p.
[[nodiscard]] double chanceBeyond(double squaredDistance, double degreesOfFreedom, int dimensions = 3,
                                  std::optional<double> count = {});

/// The gate of one who knows the type: quantile 1 - rate of chi-square with p degrees of freedom.
[[nodiscard]] double chiSquaredGate(double rate, int dimensions = 3);

/// The gate that rejects at most `rate` of the type's squeezes with this confidence: for the enrolment at
/// hand, not on average. On d' W^-1 d with d from the mean of `squeezes` squeezes, W over v degrees of
/// freedom. By Monte Carlo with a fixed seed over mean and eigenvalues of W, the content of each draw from
/// the first three moments; 10,000 draws know the confidence to 0.2 %. Between whole degrees of freedom (over
/// 16: steps of a fifth) interpolated. Takes 50 ms the first time for each number of squeezes, then it is
/// remembered. (Krishnamoorthy and Mathew, Statistical Tolerance Regions, 2009, chapter 9; Imhof 1961 for the
/// moments.)
[[nodiscard]] std::optional<double> toleranceGate(int squeezes, double degreesOfFreedom, double rate,
                                                  double confidence, int dimensions = 3);

/// How many times larger a gate is for squeezes that follow Student's t with 5 degrees of freedom in p
/// dimensions, of the same covariance.
[[nodiscard]] double heavyTailFactor(double rate, int dimensions = 3);

} // namespace gripscope
