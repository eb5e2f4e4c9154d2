// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

namespace gripscope {

/// Sample correlation over lags, with the half width of the band that 95 % of the values keep to when there
/// is no correlation: 1.96 / sqrt(N), from the asymptotic normal law (Box and Jenkins, Time Series Analysis,
/// section 2.1.6; for residuals that are white the band of the cross-correlation is the same, whatever the
/// input).
struct Correlation {
    std::vector<int> lags;
    std::vector<double> values; ///< between -1 and 1
    double band = 0;
};

/// r[k] = sum_t (e[t] - mean)(e[t-k] - mean) / sum_t (e[t] - mean)^2 for k = 0 .. lags (fewer when there are
/// not lags + 1 samples). Without samples or without variation: no values.
[[nodiscard]] Correlation autocorrelation(std::span<const double> residual, int lags);

/// r[k] = sum_t (e[t] - mean)(u[t-k] - mean) / sqrt(sum (e - mean)^2 sum (u - mean)^2) for k = -lags .. lags:
/// the residual against the input k samples earlier. Beyond the band at k >= 0: the model misses something
/// the input does; at k < 0: the input answers to the output (feedback). Both series have the same length,
/// else no values.
[[nodiscard]] Correlation crossCorrelation(std::span<const double> residual, std::span<const double> input,
                                           int lags);

} // namespace gripscope
