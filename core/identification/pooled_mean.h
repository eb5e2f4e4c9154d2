// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

namespace gripscope {

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
