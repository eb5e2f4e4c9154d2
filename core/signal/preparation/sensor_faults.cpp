// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/signal/preparation/sensor_faults.h"

#include "core/math/robust_statistics.h"
#include "core/math/value_lattice.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace gripscope {

namespace {

constexpr std::size_t shortestRun = 3, shortestSlowRun = 8;

/// What a sample is entered by that the signal reaches at speed.
struct Speed {
    double jump = 0;  ///< at once, more than this
    double steps = 0; ///< or twice in a row, at least this; 0: not judged
};

bool enteredFast(std::span<const double> values, std::size_t first, std::size_t count, const Speed& speed)
{
    if (first == 0 || count < shortestRun)
        return false;
    const double last = std::abs(values[first] - values[first - 1]);
    if (last > speed.jump)
        return true;
    if (!(speed.steps > 0) || first < 2 || count < shortestSlowRun)
        return false;
    const bool sameWay = (values[first] > values[first - 1]) == (values[first - 1] > values[first - 2]);
    const double before = std::abs(values[first - 1] - values[first - 2]);
    // What settles takes a step before the last that is at least half as large again.
    return sameWay && last >= speed.steps && before >= speed.steps && before <= 1.4 * last;
}

/// Of the drive's range: it moves by more than this where it moves a channel that is not cut off.
constexpr double leastDriveShare = 0.1;

double rangeOf(std::span<const double> values)
{
    const auto [lowest, highest] = std::minmax_element(values.begin(), values.end());
    return values.empty() ? 0 : *highest - *lowest;
}

/// Whether a run that the signal entered at speed cannot be where it came to rest: it still was on its way
/// (each step of what settles is the one before times a factor, so that the next would have been seen), or
/// the drive moved meanwhile. Its ends may belong to what the drive did before and did afterwards.
bool isNoRest(std::span<const double> values, Window run, std::span<const double> drive, const Speed& speed)
{
    constexpr double leastBefore = 0.3; // of the last step: it did not come there in one
    if (drive.empty())
        return true;
    if (rangeOf(drive.subspan(run.first + 1, run.count - 2)) > leastDriveShare * rangeOf(drive))
        return true;
    if (run.first < 2)
        return false;
    const double last = values[run.first] - values[run.first - 1];
    const double before = values[run.first - 1] - values[run.first - 2];
    const bool onItsWay = before / last >= leastBefore; // and the same way
    return onItsWay && std::abs(last) * std::min(1.0, last / before) > speed.jump;
}

std::size_t samplesInFastRuns(std::span<const double> values, double rail, const Speed& speed,
                              std::span<const double> drive)
{
    std::size_t total = 0;
    for (std::size_t i = 0; i < values.size();) {
        if (values[i] != rail) {
            ++i;
            continue;
        }
        const std::size_t first = i;
        while (i < values.size() && values[i] == rail)
            ++i;
        const Window run{first, i - first};
        if (enteredFast(values, first, run.count, speed) && isNoRest(values, run, drive, speed))
            total += i - first;
    }
    return total;
}

bool pilesUp(std::span<const double> values, double rail, bool high)
{
    std::optional<double> next;
    for (const double value : values)
        if (value != rail && (!next || (high ? value > *next : value < *next)))
            next = value;
    const auto atRail = std::count(values.begin(), values.end(), rail);
    return !next || atRail >= 2 * std::count(values.begin(), values.end(), *next);
}

/// Whether the samples that are not at the rail carry noise: what is commanded does not.
bool restIsNoisy(std::span<const double> values, double rail, double range)
{
    std::vector<double> rest;
    for (const double value : values)
        if (value != rail)
            rest.push_back(value);
    return whiteNoiseDeviation(rest) > 1e-6 * range;
}

constexpr std::size_t shortestStuck = 20;
constexpr double leastStuckShare = 0.05;
constexpr double timesTheNext = 10;
constexpr double falseAlarm = 1e-9;
constexpr double movesFromDeviations = 20;
constexpr double leastShareOfSide = 0.2;

/// The middle of the range that a drive covers, where it moves.
std::optional<double> middleOf(std::span<const double> drive)
{
    const auto [lowest, highest] = std::minmax_element(drive.begin(), drive.end());
    const double range = *highest - *lowest;
    if (!std::isfinite(range) || !(range > movesFromDeviations * whiteNoiseDeviation(drive)))
        return std::nullopt;
    return *lowest + range / 2;
}

bool onBothSides(std::span<const double> drive, double middle)
{
    const auto above = static_cast<double>(
        std::count_if(drive.begin(), drive.end(), [middle](double value) { return value > middle; }));
    const double least = leastShareOfSide * static_cast<double>(drive.size());
    return above >= least && static_cast<double>(drive.size()) - above >= least;
}

/// The longest runs of equal values, and how many neighbours are equal.
struct ChannelRuns {
    Window longest;
    std::size_t nextLongest = 0;
    std::size_t equalNeighbours = 0;
};

ChannelRuns runsOf(std::span<const double> values)
{
    ChannelRuns runs;
    for (std::size_t first = 0; first < values.size();) {
        std::size_t end = first + 1;
        while (end < values.size() && values[end] == values[first])
            ++end;
        const std::size_t count = end - first;
        runs.equalNeighbours += count - 1;
        if (count > runs.longest.count) {
            runs.nextLongest = runs.longest.count;
            runs.longest = {first, count};
        } else {
            runs.nextLongest = std::max(runs.nextLongest, count);
        }
        first = end;
    }
    return runs;
}

bool beyondChance(const ChannelRuns& runs, std::size_t samples)
{
    const std::size_t outside = samples - runs.longest.count;
    const std::size_t equal = runs.equalNeighbours - (runs.longest.count - 1);
    // Laplace's rule, since there may be few neighbours to judge by.
    const double share = (static_cast<double>(equal) + 1) / (static_cast<double>(outside) + 2);
    const auto count = static_cast<double>(runs.longest.count), all = static_cast<double>(samples);
    return count >= leastStuckShare * all && runs.longest.count >= shortestStuck &&
           count >= timesTheNext * static_cast<double>(runs.nextLongest) &&
           std::log(all) + count * std::log(std::min(share, 1.0)) < std::log(falseAlarm);
}

} // namespace

ClippedSamples clippedSamples(std::span<const double> values, double latticeStep,
                              std::span<const double> drive)
{
    ClippedSamples clipped;
    if (values.empty())
        return clipped;
    if (drive.size() != values.size())
        drive = {};
    const auto [lowest, highest] = std::minmax_element(values.begin(), values.end());
    const double low = *lowest, high = *highest;
    const auto between = static_cast<std::size_t>(std::count_if(
        values.begin(), values.end(), [low, high](double value) { return value > low && value < high; }));
    const bool levels = 2 * between < values.size();
    // A lattice is known but for rounding.
    constexpr double hardlyLess = 1 - 1e-6;
    const Speed speed{std::max(1e-6 * (high - low), 2 * latticeStep / hardlyLess),
                      2 * latticeStep * hardlyLess};
    const auto samplesAt = [&](double rail) -> std::size_t {
        if (rail == 0 || !pilesUp(values, rail, rail == high) ||
            (levels && !restIsNoisy(values, rail, high - low)))
            return 0;
        return samplesInFastRuns(values, rail, speed, drive);
    };
    clipped.atLowest = samplesAt(low);
    clipped.atHighest = samplesAt(high);
    return clipped;
}

SaturatedSamples saturatedSamples(const Recording& recording, Window window)
{
    const auto part = [window](const std::vector<double>& values) {
        const bool isThere = window.first + window.count <= values.size();
        return isThere ? std::span(values).subspan(window.first, window.count) : std::span<const double>();
    };
    const auto channel = [&](const std::vector<double>& values, const std::vector<double>& drive,
                             std::uint16_t bit) {
        SaturatedChannel found{
            0, clippedSamples(part(values), latticeStep(part(values)).value_or(0), part(drive))};
        for (std::size_t i = window.first; i < window.first + window.count; ++i)
            found.marked += i < recording.status.size() && (recording.status[i] & bit) != 0 ? 1 : 0;
        return found;
    };
    return {channel(recording.force, recording.position, StatusForceSaturated),
            channel(recording.position, recording.force, StatusPositionSaturated)};
}

std::optional<Window> stuckStretch(std::span<const double> channel, std::span<const double> drive)
{
    if (channel.size() != drive.size() || channel.size() < shortestStuck)
        return std::nullopt;
    const std::optional<double> middle = middleOf(drive);
    if (!middle)
        return std::nullopt;
    const ChannelRuns runs = runsOf(channel);
    const bool whole = runs.longest.count == channel.size();
    if (!whole && !beyondChance(runs, channel.size()))
        return std::nullopt;
    const auto meanwhile = drive.subspan(runs.longest.first, runs.longest.count);
    return onBothSides(meanwhile, *middle) ? std::optional(runs.longest) : std::nullopt;
}

} // namespace gripscope
