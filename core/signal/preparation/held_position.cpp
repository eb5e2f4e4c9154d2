// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/signal/preparation/held_position.h"

#include "core/math/robust_statistics.h"
#include "core/math/value_lattice.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace gripscope {

namespace {

constexpr std::size_t fewestBefore = 5;
constexpr double contactShare = 0.05; ///< of the largest force
constexpr std::size_t shortestStand = 3, fewestStands = 5;
constexpr double smallestMove = 0.01; ///< of the position's range
constexpr double smallestMoveInSteps = 20;
constexpr double leastStandingShare = 0.4;
constexpr double leastRise = 0.1; ///< of the largest force
constexpr double noiseDeviations = 6;

/// A stretch of pushing, the force's sign taken out.
struct Push {
    double sign = 0, threshold = 0, weight = 0;
    Window window;
};

void keepHeavier(Push& heaviest, std::span<const double> force, double sign)
{
    double largest = 0;
    for (const double value : force)
        largest = std::max(largest, sign * value);
    Push push{sign, contactShare * largest, 0, {}};
    for (std::size_t i = 0; i < force.size(); ++i) {
        const double pushing = sign * force[i];
        if (pushing <= push.threshold) {
            push.window.count = 0;
            push.weight = 0;
            continue;
        }
        if (push.window.count++ == 0)
            push.window.first = i;
        push.weight += std::sqrt(pushing);
        if (push.weight > heaviest.weight)
            heaviest = push;
    }
}

Push pushOf(std::span<const double> force)
{
    Push heaviest;
    keepHeavier(heaviest, force, 1);
    keepHeavier(heaviest, force, -1);
    return heaviest;
}

/// Where the position stands still after it moved, up to `end`.
std::vector<Window> standsOf(std::span<const double> position, std::size_t end, double move)
{
    std::vector<Window> stands;
    std::optional<double> before;
    for (std::size_t first = 0; first < end;) {
        std::size_t next = first + 1;
        while (next < position.size() && position[next] == position[first])
            ++next;
        if (next - first >= shortestStand) {
            if (before && std::abs(position[first] - *before) >= move)
                stands.push_back({first, next - first});
            before = position[first];
        }
        first = next;
    }
    return stands;
}

bool standMostOfTheTime(const std::vector<Window>& stands)
{
    if (stands.size() < fewestStands)
        return false;
    std::size_t standing = 0;
    for (const Window& stand : stands)
        standing += stand.count;
    const std::size_t all = stands.back().first + stands.back().count - stands.front().first;
    return static_cast<double>(standing) >= leastStandingShare * static_cast<double>(all);
}

/// Whether the force (pushing positive) rises while the position stands, from the touch to the largest force.
bool risesMeanwhile(std::span<const double> position, std::span<const double> force, std::size_t touch,
                    std::size_t top, double noise)
{
    double rise = 0, runs = 0;
    bool stood = false;
    for (std::size_t i = touch; i <= top; ++i) {
        const bool stands = position[i] == position[i - 1];
        rise += stands ? force[i] - force[i - 1] : 0;
        runs += stands && !stood ? 1 : 0;
        stood = stands;
    }
    return runs > 0 &&
           rise >= std::max(leastRise * force[top], noiseDeviations * noise * std::sqrt(2 * runs));
}

double standingTime(const std::vector<Window>& stands, std::span<const double> time_s)
{
    std::vector<double> durations;
    durations.reserve(stands.size());
    for (const Window& stand : stands)
        durations.push_back(time_s[std::min(stand.first + stand.count, time_s.size() - 1)] -
                            time_s[stand.first]);
    return quantile(durations, 0.5);
}

std::vector<double> times(double sign, std::span<const double> values)
{
    std::vector<double> out(values.begin(), values.end());
    for (double& value : out)
        value *= sign;
    return out;
}

void countSpikes(HeldPosition& held, std::span<const double> force, const Push& push)
{
    for (std::size_t i = 0; i < force.size(); ++i) {
        const bool inside = i >= push.window.first && i < push.window.first + push.window.count;
        if (inside || std::abs(force[i]) <= push.threshold)
            continue;
        ++held.spikes;
        if (std::abs(force[i]) > std::abs(held.largestSpike))
            held.largestSpike = force[i];
    }
}

} // namespace

std::optional<HeldPosition> heldPosition(std::span<const double> time_s, std::span<const double> force,
                                         std::span<const double> position)
{
    if (force.size() != position.size() || time_s.size() != force.size() || force.size() < fewestBefore + 1)
        return std::nullopt;
    const Push push = pushOf(force);
    if (push.window.count == 0 || push.window.first < fewestBefore)
        return std::nullopt;
    HeldPosition held;
    held.contact = push.window;
    held.force = times(push.sign, force);
    const auto contact = std::span<const double>(held.force).subspan(push.window.first, push.window.count);
    const auto top =
        push.window.first + static_cast<std::size_t>(std::ranges::max_element(contact) - contact.begin());
    const auto [lowest, highest] = std::ranges::minmax_element(position);
    const double range = *highest - *lowest;
    const double move =
        std::max(smallestMove * range, smallestMoveInSteps * latticeStep(position).value_or(0));
    held.forceNoise = whiteNoiseDeviation(force);
    if (!std::isfinite(range) || !(range > 0) || !std::isfinite(held.forceNoise))
        return std::nullopt;
    const std::vector<Window> stands = standsOf(position, top, move);
    if (!standMostOfTheTime(stands) ||
        !risesMeanwhile(position, held.force, push.window.first, top, held.forceNoise))
        return std::nullopt;
    const auto air = position.first(push.window.first);
    const double before = std::accumulate(air.begin(), air.end(), 0.0) / static_cast<double>(air.size());
    const double closing = position[top] < before ? -1 : 1;
    held.opening = closing != push.sign;
    held.position = times(closing, position);
    held.time_s.assign(time_s.begin(), time_s.end());
    held.interval_s = standingTime(stands, time_s);
    held.clockBound_s = clockBoundInRenewals * held.interval_s;
    countSpikes(held, force, push);
    return held;
}

} // namespace gripscope
