// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/recognition/stranger_background.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gripscope {

namespace {

double ellipsoidVolume(const TypePrediction& prediction, double squared)
{
    return 4 * std::numbers::pi / 3 * squared * std::sqrt(squared) * std::exp(prediction.logDeterminant / 2);
}

/// Squared distance at which the type's density falls to a level.
double squaredAt(const TypePrediction& prediction, double logLevel)
{
    const double v = prediction.tailDegrees;
    const double exponent = 2 / (v + 1) * (prediction.logDensityAtMean - logLevel);
    return v * std::expm1(std::clamp(exponent, 0.0, 600.0));
}

double volumeAbove(const std::vector<TypePrediction>& predictions, const std::vector<double>& gates,
                   double logLevel)
{
    double volume = 0;
    for (std::size_t i = 0; i < predictions.size(); ++i)
        volume += ellipsoidVolume(predictions[i], std::min(gates[i], squaredAt(predictions[i], logLevel)));
    return volume;
}

} // namespace

StrangerLimit strangerLimit(const std::vector<TypePrediction>& predictions, const std::vector<double>& gates,
                            double logVolume, double rate)
{
    StrangerLimit limit;
    for (std::size_t i = 0; i < predictions.size(); ++i)
        limit.insideGates += ellipsoidVolume(predictions[i], gates[i]) / logVolume;
    limit.insideGates = std::min(1.0, limit.insideGates);
    limit.accepted = limit.insideGates;
    if (limit.insideGates <= rate)
        return limit;
    double high = -1e300;
    for (const TypePrediction& prediction : predictions)
        high = std::max(high, prediction.logDensityAtMean);
    double low = high - 700;
    for (int halving = 0; halving < 60; ++halving) {
        const double middle = (low + high) / 2;
        (volumeAbove(predictions, gates, middle) > rate * logVolume ? low : high) = middle;
    }
    limit.leastLogDensity = high;
    limit.accepted = volumeAbove(predictions, gates, high) / logVolume;
    return limit;
}

} // namespace gripscope
