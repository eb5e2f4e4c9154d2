// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <span>

namespace gripscope {

/// 100 (1 - |y - yhat| / |y - mean y|), percent, over all of `measured` (Ljung, System Identification,
/// "fit"). Nothing when y is constant or a number is not finite.
[[nodiscard]] std::optional<double> fitPercent(std::span<const double> measured,
                                               std::span<const double> model);

/// 2^n such that the largest magnitude in `values` lies in [1, 2) after division by it; 1 when all are zero.
[[nodiscard]] double powerOfTwoScale(std::span<const double> values);

[[nodiscard]] bool allFinite(std::span<const double> values);

} // namespace gripscope
