// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>

namespace gripscope {

/// Ljung-Box: p-value of the hypothesis that the residuals are white, from Q = N (N + 2) sum r_k^2 / (N - k)
/// over `lags` autocorrelations, chi-square with lags - fittedLags degrees of freedom (Ljung and Box 1978;
/// fittedLags: the number of autoregressive coefficients fitted, 0 for output error). Nothing when there are
/// too few residuals or when they do not vary.
[[nodiscard]] std::optional<double> ljungBoxP(std::span<const double> residuals, int fittedLags);

} // namespace gripscope
