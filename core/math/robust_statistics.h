// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

namespace gripscope {

/// The value that the share `probability` (0 to 1) of the samples keeps below, the nearest order statistic:
/// index round(probability (N - 1)). Zero without samples. O(N).
[[nodiscard]] double quantile(std::span<const double> values, double probability);

/// The standard deviation of the white noise on a signal that is smooth most of the time: the median absolute
/// third difference over 0.6745 sqrt(20), its value for Gaussian noise. A signal that moves smoothly cancels
/// in third differences up to (omega T)^3, and jumps are rare enough not to move a median (von Neumann 1941
/// on differences, Hampel 1974 on the median). A signal as fast as its samples counts as noise: then this is
/// too large. Zero for fewer than 8 samples.
[[nodiscard]] double whiteNoiseDeviation(std::span<const double> values);

struct ValueWithError {
    double value = 0;
    double standardError = 0;
};

/// One value from several measurements of the same thing: the mean weighted with 1 / (error^2 + between^2),
/// `between` the scatter beyond their own errors (method of moments, not below zero; DerSimonian and Laird,
/// Controlled Clinical Trials 7, 1986), so that errors that are stated too small make the mean's error
/// larger, not its value wrong. At least one, values finite, errors above zero.
[[nodiscard]] ValueWithError pooledMean(std::span<const ValueWithError> measurements);

} // namespace gripscope
