// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/format/derived_quantities.h"

#include <cmath>
#include <numbers>

namespace gripscope {

std::optional<DerivedQuantities> derivedQuantities(const Estimate& estimate)
{
    if (!estimate.parameters || !(estimate.parameters->m > 0) || !(estimate.parameters->k > 0))
        return std::nullopt;
    const auto [m, b, k] = *estimate.parameters;
    DerivedQuantities result;
    result.naturalFrequency_Hz = std::sqrt(k / m) / (2 * std::numbers::pi);
    result.dampingRatio = b / (2 * std::sqrt(k) * std::sqrt(m));
    if (!estimate.covariance)
        return result;
    const auto standardError = [&](const Eigen::Vector3d& gradient) -> std::optional<double> {
        const double variance = gradient.dot(*estimate.covariance * gradient);
        return variance > 0 && std::isfinite(variance) ? std::optional(std::sqrt(variance)) : std::nullopt;
    };
    const double f = result.naturalFrequency_Hz;
    const double zeta = result.dampingRatio;
    result.naturalFrequencyError_Hz = standardError({-f / (2 * m), 0, f / (2 * k)});
    result.dampingRatioError =
        standardError({-zeta / (2 * m), 1 / (2 * std::sqrt(k) * std::sqrt(m)), -zeta / (2 * k)});
    return result;
}

} // namespace gripscope
