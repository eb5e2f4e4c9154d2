// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <vector>

namespace gripscope {

/// e[t] = sum_i coefficients[i-1] e[t-i] + w[t], w white: the model that a series of residuals has of itself.
struct SeriesModel {
    std::vector<double> coefficients; ///< empty: white
    double logLikelihood = 0;         ///< Gaussian: -N/2 (ln(2 pi var w) + 1)
};

/// Yule-Walker by Levinson's recursion, always stationary; the order, 0 to min(20, N / 10), by BIC. For
/// whitening a regression and for comparing models; the errors of m, b and k have a noise model of their own,
/// which counts what the parameters took out. Nothing for a series of zeros or numbers that are not finite.
[[nodiscard]] std::optional<SeriesModel> autoregressiveModel(std::span<const double> series);

} // namespace gripscope
