// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/format/cursor_reading.h"

#include "core/math/normal_interval.h"
#include "core/math/robust_statistics.h"
#include "core/signal/recording/units.h"

#include <algorithm>
#include <cmath>

namespace gripscope {

namespace {

constexpr double around_s = 0.05; ///< to either side: enough samples for the noise, few for the part to move

/// The smallest difference between two of the values: the sensor's step where it is coarser than the noise.
double smallestStep(std::vector<double> values)
{
    std::sort(values.begin(), values.end());
    double step = 0;
    for (std::size_t i = 1; i < values.size(); ++i) {
        const double difference = values[i] - values[i - 1];
        if (difference > 0 && (step == 0 || difference < step))
            step = difference;
    }
    return step;
}

double halfWidthOf(const std::vector<double>& values)
{
    return normal95 * std::hypot(whiteNoiseDeviation(values), smallestStep(values) / std::sqrt(12.0));
}

std::optional<ReadValue> readChannel(const LiveHistory& history, LiveHistory::Channel channel, double time_s,
                                     const std::vector<double>& nearby)
{
    const std::optional<LiveHistory::Reading> found = history.reading(channel, time_s);
    if (!found)
        return std::nullopt;
    if (time_s < history.oldestFullRateTime_s())
        return ReadValue{found->middle(), (found->high - found->low) / 2, true};
    return ReadValue{found->middle(), halfWidthOf(nearby), false};
}

} // namespace

CursorReading readCursor(const LiveHistory& history, double time_s)
{
    std::vector<double> forces;
    std::vector<double> positions;
    for (const Sample& sample : history.samples(time_s - around_s, time_s + around_s)) {
        forces.push_back(sample.force);
        positions.push_back(sample.position);
    }
    return {readChannel(history, LiveHistory::Channel::Force, time_s, forces),
            readChannel(history, LiveHistory::Channel::Position, time_s, positions)};
}

std::optional<ReadValue> difference(const std::optional<ReadValue>& first,
                                    const std::optional<ReadValue>& second)
{
    if (!first || !second)
        return std::nullopt;
    return ReadValue{second->value - first->value, std::hypot(first->halfWidth, second->halfWidth),
                     first->range || second->range};
}

std::optional<ReadValue> slopeBetween(const CursorReading& first, const CursorReading& second)
{
    const std::optional<ReadValue> force = difference(first.force, second.force);
    const std::optional<ReadValue> position = difference(first.position, second.position);
    if (!force || !position || std::abs(position->value) <= position->halfWidth || position->value == 0)
        return std::nullopt;
    const double slope = force->value / position->value;
    const double halfWidth =
        std::hypot(force->halfWidth, slope * position->halfWidth) / std::abs(position->value);
    return ReadValue{slope, halfWidth, force->range || position->range};
}

FormattedNumber slopeText(const ReadValue& slope, const QString& forceUnit, const QString& positionUnit)
{
    const std::optional<double> si = siFactor(forceUnit, positionUnit);
    const double factor = si.value_or(1);
    const QString unit = comparableUnits(forceUnit, positionUnit).k;
    const double halfWidth = factor * slope.halfWidth;
    return formatNumber(factor * slope.value, halfWidth > 0 ? std::optional(halfWidth) : std::nullopt,
                        unit == QLatin1String("1") ? QString() : unit);
}

} // namespace gripscope
