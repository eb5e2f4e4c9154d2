// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/steady_reading.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace gripscope {

namespace {

constexpr std::size_t blocks = 10;
constexpr double criticalT = 5.041; ///< Student's t, two-sided p = 0.001, blocks - 2 degrees of freedom

double meanOf(std::span<const double> values)
{
    double sum = 0;
    for (const double value : values)
        sum += value - values.front();
    return values.front() + sum / static_cast<double>(values.size());
}

struct Line {
    double rise = 0;  ///< over the whole length
    double error = 0; ///< standard error of it
};
Line lineThrough(const std::array<double, blocks>& means)
{
    const double middle = meanOf(means);
    constexpr double center = (blocks - 1) / 2.0;
    double squares = 0;
    double products = 0;
    for (std::size_t i = 0; i < blocks; ++i) {
        const double x = static_cast<double>(i) - center;
        squares += x * x;
        products += x * (means[i] - middle);
    }
    const double slope = products / squares;
    double residual = 0;
    for (std::size_t i = 0; i < blocks; ++i)
        residual += std::pow(means[i] - middle - slope * (static_cast<double>(i) - center), 2);
    return {slope * blocks, blocks * std::sqrt(residual / (blocks - 2) / squares)};
}

} // namespace

SteadyReading steadyReading(std::span<const double> values, const SteadyOptions& options)
{
    SteadyReading reading;
    reading.samples = values.size();
    if (values.size() < std::max(options.leastSamples, 2 * blocks))
        return reading;
    reading.mean = meanOf(values);
    double squares = 0;
    for (const double value : values)
        squares += (value - reading.mean) * (value - reading.mean);
    reading.deviation = std::sqrt(squares / static_cast<double>(values.size() - 1));
    std::array<double, blocks> means{};
    const std::size_t length = values.size() / blocks;
    for (std::size_t i = 0; i < blocks; ++i)
        means[i] = meanOf(values.subspan(i * length, length));
    const Line line = lineThrough(means);
    reading.drift = line.rise;
    const bool matters = std::abs(line.rise) > options.driftAllowed;
    reading.status =
        matters && std::abs(line.rise) > criticalT * line.error ? SteadyStatus::Moving : SteadyStatus::Steady;
    return reading;
}

} // namespace gripscope
