// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/math/robust_statistics.h"

#include <algorithm>
#include <cmath>
#include <vector>

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

double quantile(std::span<const double> values, double probability)
{
    if (values.empty())
        return 0;
    std::vector<double> sorted(values.begin(), values.end());
    const double last = static_cast<double>(sorted.size() - 1);
    const auto at = static_cast<std::ptrdiff_t>(std::llround(std::clamp(probability, 0.0, 1.0) * last));
    std::nth_element(sorted.begin(), sorted.begin() + at, sorted.end());
    return sorted[static_cast<std::size_t>(at)];
}

double whiteNoiseDeviation(std::span<const double> values)
{
    constexpr std::size_t fewest = 8;
    if (values.size() < fewest)
        return 0;
    std::vector<double> differences(values.size() - 3);
    for (std::size_t i = 0; i < differences.size(); ++i) {
        // Halves keep the sum of the largest numbers finite.
        const double outer = values[i + 3] / 2 - values[i] / 2;
        const double inner = values[i + 2] / 2 - values[i + 1] / 2;
        differences[i] = std::abs(outer - 3 * inner);
    }
    const double median = quantile(differences, 0.5);
    constexpr double gaussianMedian = 0.6744897501960817;
    const double deviation = 2 * (median / (gaussianMedian * std::sqrt(20.0)));
    return std::isfinite(deviation) ? deviation : 0;
}

ValueWithError pooledMean(std::span<const ValueWithError> measurements)
{
    const WeightedMean mean = weightedMean(measurements, varianceBetween(measurements));
    return {mean.value, 1 / std::sqrt(mean.weights)};
}

} // namespace gripscope
