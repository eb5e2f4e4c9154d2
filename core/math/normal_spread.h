// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace gripscope {

/// How the range and the standard deviation of a few independent normal values are distributed, sigma
/// being 1.

/// Mean and standard deviation of the range R of n values: d2 and d3.
struct RangeMoments {
    double d2 = 0, d3 = 0;
};

///     d2 = int [1 - Phi(x)^n - (1 - Phi(x))^n] dx,  d3 = sqrt(2 int w P(R > w) dw - d2^2)
/// Good to 1e-10 for n from 2 (fewer count as 2) to 1000. Source: Tippett, On the extreme individuals and the
/// range of samples, Biometrika 1925. About a millisecond: the double integral of d3.
[[nodiscard]] RangeMoments rangeMoments(int size);
/// d2 alone, which is a single integral.
[[nodiscard]] double meanNormalRange(int size);

/// c4 = E[chi] / sqrt(nu) = sqrt(2/nu) Gamma((nu + 1)/2) / Gamma(nu/2): the mean of a standard deviation with
/// so many degrees of freedom nu, whole or not, above 0; with n - 1 that of n values.
[[nodiscard]] double deviationBias(double degreesOfFreedom);

/// The degrees of freedom of the chi that varies as much, relatively: the root nu of
/// 1/c4(nu)^2 - 1 = `relativeVariance` (Patnaik, The use of mean range as an estimator of variance,
/// Biometrika 1950). Above 0; not above 1e9.
[[nodiscard]] double equivalentDegrees(double relativeVariance);

} // namespace gripscope
