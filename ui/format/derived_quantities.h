// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/model/estimate.h"

#include <optional>

namespace gripscope {

/// What m, b and k mean for a person: f = sqrt(k/m) / 2 pi in hertz, zeta = b / (2 sqrt(k m)), with their
/// standard errors to first order from the covariance. Both are the same in any consistent units.
struct DerivedQuantities {
    double naturalFrequency_Hz = 0;
    double dampingRatio = 0;
    std::optional<double> naturalFrequencyError_Hz, dampingRatioError; ///< standard errors
};
/// Nothing without positive m and k.
[[nodiscard]] std::optional<DerivedQuantities> derivedQuantities(const Estimate& estimate);

} // namespace gripscope
