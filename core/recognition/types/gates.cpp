// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/recognition/types/gates.h"

#include "core/math/distributions.h"

#include <algorithm>
#include <cmath>

namespace gripscope {

namespace {

constexpr double tailDegrees = 5;

} // namespace

std::optional<double> predictiveGate(double degreesOfFreedom, double rate, int dimensions)
{
    const double v = degreesOfFreedom;
    if (!(dimensions >= 1 && v >= dimensions) || !(rate > 0 && rate < 1))
        return {};
    const double quantile = fisherQuantileAbove(rate, dimensions, v - (dimensions - 1));
    const double gate = dimensions * v / (v - (dimensions - 1)) * quantile;
    return std::isfinite(gate) ? std::optional(gate) : std::nullopt; // a rate next to 0 and v = p
}

double chanceBeyond(double squaredDistance, double degreesOfFreedom, int dimensions,
                    std::optional<double> count)
{
    const double components = count.value_or(dimensions);
    const double known = degreesOfFreedom - (dimensions - 1);
    const double ratio = squaredDistance * known / (components * degreesOfFreedom);
    if (!std::isfinite(ratio))
        return 0;
    return fisherAbove(std::max(0.0, ratio), components, known);
}

double chiSquaredGate(double rate, int dimensions)
{
    return chiSquaredQuantileAbove(rate, dimensions);
}

double heavyTailFactor(double rate, int dimensions)
{
    const double heavy =
        dimensions * (tailDegrees - 2) / tailDegrees * fisherQuantileAbove(rate, dimensions, tailDegrees);
    return std::max(1.0, heavy / chiSquaredGate(rate, dimensions));
}

} // namespace gripscope
