// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/protocol/arming_obstacle.h"

#include "core/base/words.h"
#include "devices/protocol/codec.h"

#include <initializer_list>
#include <limits>

namespace gripscope::protocol {

std::optional<FieldProblem> armingObstacle(const MeasurementFeature& measurement, const LimitsFeature& limits)
{
    constexpr double mostCounts = std::numeric_limits<std::int32_t>::max();
    constexpr double mostSamples = std::numeric_limits<std::uint32_t>::max();
    const auto number = [](auto unit) { return static_cast<double>(static_cast<std::uint8_t>(unit)); };
    // A force or a travel in no known unit could not be held against a limit.
    for (const std::optional<FieldProblem>& problem :
         {outside(Field::TakesCommands, measurement.commandable ? 1 : 0, 1, 1),
          outside(Field::Watchdog, measurement.watchdog_ms, shortestWatchdog_ms, longestWatchdog_ms),
          outside(Field::ForceUnit, number(measurement.forceUnit), 1, number(ForceUnit::Kilonewton)),
          outside(Field::PositionUnit, number(measurement.positionUnit), 1, number(PositionUnit::Micrometre)),
          outside(Field::ForcePerCount, measurement.forcePerCount, leastPerCount, mostPerCount),
          outside(Field::PositionPerCount, measurement.positionPerCount, leastPerCount, mostPerCount),
          outside(Field::SampleTime, measurement.sampleTime_s, shortestSampleTime_s, longestReportPeriod_s),
          outside(Field::Lag, measurement.forceLag_s, -longestLag_s, longestLag_s),
          outside(Field::LargestForce, limits.maxForce, 1, mostCounts),
          outside(Field::LongestTravel, limits.maxTravel, 1, mostCounts),
          outside(Field::LongestExcitation, limits.maxSamples, 1, mostSamples)})
        if (problem)
            return problem;
    return std::nullopt;
}

QString describeObstacle(const FieldProblem& problem)
{
    if (problem.field == Field::SampleTime && problem.value > problem.most)
        return tooSeldom(1e3 * problem.value, 1e3 * problem.most); // nothing is wrong with it; it is slow
    return describe(problem);
}

QString tooSeldom(double period_ms, double longest_ms)
{
    return Words::tr("its reports come every %1 ms; a gripper that is to be stopped in time sends one "
                     "every %2 ms at least. It can be listened to")
        .arg(Words::number(period_ms, 'f', 1), Words::number(longest_ms, 'g', 3));
}

} // namespace gripscope::protocol
