// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/math/fit.h"

#include <Eigen/Core>

#include <algorithm>
#include <cmath>

namespace gripscope {

std::optional<double> fitPercent(std::span<const double> measured, std::span<const double> model)
{
    if (measured.empty() || measured.size() != model.size())
        return std::nullopt;
    // Scaled, so that squares neither overflow nor vanish.
    const double scale = powerOfTwoScale(measured);
    double mean = 0;
    for (const double y : measured)
        mean += y / scale;
    mean /= static_cast<double>(measured.size());
    double spread = 0;
    double error = 0;
    for (std::size_t i = 0; i < measured.size(); ++i) {
        const double y = measured[i] / scale;
        spread += (y - mean) * (y - mean);
        error += (y - model[i] / scale) * (y - model[i] / scale);
    }
    const double fit = 100 * (1 - std::sqrt(error) / std::sqrt(spread));
    return spread > 0 && std::isfinite(fit) ? std::optional(fit) : std::nullopt;
}

double powerOfTwoScale(std::span<const double> values)
{
    if (values.empty())
        return 1;
    const double largest =
        Eigen::Map<const Eigen::ArrayXd>(values.data(), static_cast<Eigen::Index>(values.size()))
            .abs()
            .maxCoeff();
    if (!(largest > 0) || !std::isfinite(largest))
        return 1;
    return std::ldexp(1.0, std::ilogb(largest));
}

bool allFinite(std::span<const double> values)
{
    return std::all_of(values.begin(), values.end(), [](double value) { return std::isfinite(value); });
}

} // namespace gripscope
