// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace gripscope {

/// Distribution functions and quantiles by Boost.Math, compiled once. "Below" is P(X <= x), "Above" P(X > x),
/// which keeps its digits where it is small; a quantile "Above" is the x that is exceeded with that
/// probability. Degrees of freedom above 0, probabilities between 0 and 1: a bug otherwise
/// (std::domain_error). Overflow gives infinity; in double precision throughout, which is good to 1e-13 and
/// three times as fast as with long double, and a verdict is mostly quantiles.

[[nodiscard]] double normalDensity(double x);
[[nodiscard]] double normalBelow(double x);
[[nodiscard]] double normalAbove(double x);
[[nodiscard]] double normalQuantile(double below);
[[nodiscard]] double normalQuantileAbove(double above);

[[nodiscard]] double studentAbove(double t, double degreesOfFreedom);
[[nodiscard]] double studentQuantile(double below, double degreesOfFreedom);
[[nodiscard]] double studentQuantileAbove(double above, double degreesOfFreedom);
/// Of (z + `shift`) / sqrt(chi^2 / degreesOfFreedom), z standard normal; `shift` up to some thousands.
[[nodiscard]] double nonCentralStudentBelow(double t, double degreesOfFreedom, double shift);
[[nodiscard]] double nonCentralStudentQuantile(double below, double degreesOfFreedom, double shift);

[[nodiscard]] double chiSquaredBelow(double x, double degreesOfFreedom);
[[nodiscard]] double chiSquaredAbove(double x, double degreesOfFreedom);
[[nodiscard]] double chiSquaredQuantile(double below, double degreesOfFreedom);
[[nodiscard]] double chiSquaredQuantileAbove(double above, double degreesOfFreedom);
/// Of sum (z_i + d_i)^2, z standard normal, sum d_i^2 = `shift`.
[[nodiscard]] double nonCentralChiSquaredBelow(double x, double degreesOfFreedom, double shift);

/// Fisher's F: a mean of `numerator` squares over one of `denominator`.
[[nodiscard]] double fisherAbove(double f, double numerator, double denominator);
[[nodiscard]] double fisherQuantile(double below, double numerator, double denominator);
[[nodiscard]] double fisherQuantileAbove(double above, double numerator, double denominator);
/// The same where the numerator's squares are shifted, as nonCentralChiSquaredBelow().
[[nodiscard]] double nonCentralFisherBelow(double f, double numerator, double denominator, double shift);

[[nodiscard]] double gammaAbove(double x, double shape, double scale);
[[nodiscard]] double betaQuantile(double below, double alpha, double beta);
/// log Gamma(x) for x > 0; std::lgamma() writes a global, which threads may not.
[[nodiscard]] double logGamma(double x);

} // namespace gripscope
