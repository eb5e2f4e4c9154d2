// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/pooled_mean.h"

#include <algorithm>
#include <cmath>

namespace gripscope {

namespace {

struct WeightedMean {
    double value = 0, weights = 0, squaredWeights = 0;
};

WeightedMean weightedMean(std::span<const ValueWithError> measurements, double between)
{
    WeightedMean mean;
    for (const ValueWithError& one : measurements) {
        const double weight = 1 / (one.standardError * one.standardError + between);
        mean.weights += weight;
        mean.squaredWeights += weight * weight;
        mean.value += weight * one.value;
    }
    mean.value /= mean.weights;
    return mean;
}

double varianceBetween(std::span<const ValueWithError> measurements)
{
    const WeightedMean mean = weightedMean(measurements, 0);
    double scatter = 0;
    for (const ValueWithError& one : measurements)
        scatter += std::pow((one.value - mean.value) / one.standardError, 2);
    const double free = static_cast<double>(measurements.size()) - 1;
    const double scale = mean.weights - mean.squaredWeights / mean.weights;
    return scale > 0 ? std::max((scatter - free) / scale, 0.0) : 0;
}

} // namespace

ValueWithError pooledMean(std::span<const ValueWithError> measurements)
{
    const WeightedMean mean = weightedMean(measurements, varianceBetween(measurements));
    return {mean.value, 1 / std::sqrt(mean.weights)};
}

} // namespace gripscope
