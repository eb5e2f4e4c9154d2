// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/signal/resting_force.h"

#include <cmath>

namespace gripscope {

std::optional<double> restingForceNoise(std::span<const double> force)
{
    if (force.size() < leastRestingSamples)
        return std::nullopt;
    const double origin = force.front();
    double squares = 0, sum = 0, sumOfSquares = 0;
    std::size_t moved = 0;
    for (std::size_t i = 1; i < force.size(); ++i) {
        const double difference = force[i] - force[i - 1], value = force[i] - origin;
        squares += difference * difference;
        moved += difference != 0 ? 1 : 0;
        sum += value;
        sumOfSquares += value * value;
    }
    const auto differences = static_cast<double>(force.size() - 1);
    const auto count = static_cast<double>(force.size());
    const double noise = squares / (2 * differences);
    const double whole = (sumOfSquares - sum * sum / count) / differences;
    if (2 * static_cast<double>(moved) < differences || !std::isfinite(noise) || !(whole <= 2 * noise))
        return std::nullopt;
    return std::sqrt(noise);
}

} // namespace gripscope
