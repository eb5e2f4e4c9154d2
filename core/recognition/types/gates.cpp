// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/recognition/types/gates.h"

#include "core/math/distributions.h"
#include "core/recognition/types/dimensions.h"

#include <algorithm>
#include <cmath>

namespace gripscope {

namespace {

constexpr double tailDegrees = 5;

} // namespace

std::optional<double> predictiveGate(double degreesOfFreedom, double rate)
{
    const double v = degreesOfFreedom;
    if (!(v >= dimensions) || !(rate > 0 && rate < 1))
        return {};
    const double quantile = fisherQuantileAbove(rate, dimensions, v - 2);
    const double gate = dimensions * v / (v - 2) * quantile;
    return std::isfinite(gate) ? std::optional(gate) : std::nullopt; // a rate next to 0 and v = 3
}

double chanceBeyond(double squaredDistance, double degreesOfFreedom, double count)
{
    const double ratio = squaredDistance * (degreesOfFreedom - 2) / (count * degreesOfFreedom);
    if (!std::isfinite(ratio))
        return 0;
    return fisherAbove(std::max(0.0, ratio), count, degreesOfFreedom - 2);
}

double chiSquaredGate(double rate)
{
    return chiSquaredQuantileAbove(rate, dimensions);
}

double heavyTailFactor(double rate)
{
    const double heavy =
        dimensions * (tailDegrees - 2) / tailDegrees * fisherQuantileAbove(rate, dimensions, tailDegrees);
    return std::max(1.0, heavy / chiSquaredGate(rate));
}

} // namespace gripscope
