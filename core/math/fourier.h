// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <complex>
#include <cstddef>
#include <span>
#include <vector>

namespace gripscope {

/// In place: X[q] = sum_t x[t] exp(-2 pi i q t / n), n a power of two (Cooley and Tukey 1965); `inverse` has
/// the other sign in the exponent and no division by n.
void powerOfTwoTransform(std::vector<std::complex<double>>& values, bool inverse = false);

/// The smallest power of two that is at least `count`.
[[nodiscard]] std::size_t powerOfTwoAtLeast(std::size_t count);

/// The discrete Fourier transform of n real values, n any number, divided by sqrt(n) so that white noise
/// keeps its variance: bins q = 0..n/2 of X[q] = n^-1/2 sum_t x[t] exp(-2 pi i q t / n). O(n log n) for every
/// n (Bluestein 1970: a convolution with a chirp, done with powers of two).
[[nodiscard]] std::vector<std::complex<double>> fourierTransform(std::span<const double> values);

/// c[lag] = sum_t x[t] x[t + lag] for lag = 0..largestLag, no value beyond the ends. O(n log n).
[[nodiscard]] std::vector<double> autocorrelation(std::span<const double> values, std::size_t largestLag);

} // namespace gripscope
