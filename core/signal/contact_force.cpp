// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/signal/contact_force.h"

#include "core/signal/robust_statistics.h"

#include <algorithm>
#include <cmath>

namespace gripscope {

ContactForce contactForce(std::span<const double> force)
{
    constexpr double restShare = 0.05, noiseDeviations = 6, rare = 0.01;
    ContactForce result;
    const double low = quantile(force, rare), high = quantile(force, 1 - rare);
    result.sign = high >= -low ? 1 : -1;
    const double largest = std::max(high, -low), smallest = result.sign > 0 ? low : -high;
    result.threshold = std::max(restShare * largest, noiseDeviations * whiteNoiseDeviation(force));
    result.oneSided = largest > 0 && result.threshold < largest / 2 && smallest >= -result.threshold;
    return result;
}

} // namespace gripscope
