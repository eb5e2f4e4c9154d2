// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/math/robust_statistics.h"
#include "core/signal/preparation/preparation_parts.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

namespace gripscope {

namespace {

bool isMoving(const Recording& recording, std::size_t i)
{
    return (recording.status[i] & StatusMoving) != 0;
}

bool hasMovingSamples(const Recording& recording)
{
    return recording.status.size() == recording.size() &&
           std::any_of(recording.status.begin(), recording.status.end(),
                       [](std::uint16_t status) { return (status & StatusMoving) != 0; });
}

/// From the first to one past the last moving sample.
Window movingSpan(const Recording& recording)
{
    std::size_t first = 0;
    while (!isMoving(recording, first))
        ++first;
    std::size_t end = recording.size();
    while (!isMoving(recording, end - 1))
        --end;
    return {first, end - first};
}

/// What the force channel of a gripper that can only push says about being in contact.
struct ContactForce {
    double sign = 1;      ///< of a pushing force in this record
    double threshold = 0; ///< above it (sign taken out) the gripper pushes
    bool oneSided = false;
};

/// The threshold is 5 % of the largest force (its 99 % quantile) or six standard deviations of its noise, the
/// larger of the two. The record is one-sided when no more than one sample in a hundred lies below minus the
/// threshold: a force that pulls belongs to an object that is held from both sides.
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

constexpr std::size_t shortestRest = 5;
/// A squeeze shorter than this is none: the phases were misread.
constexpr std::size_t shortestSqueeze = 20;
constexpr double smallestTravel = 0.1;  ///< of the positions' range in contact
constexpr double positionMargin = 0.05; ///< of the same

/// The two channels so that pushing is positive, perhaps with time reversed.
struct Channels {
    std::vector<double> force, position;

    [[nodiscard]] Channels reversed() const
    {
        return {{force.rbegin(), force.rend()}, {position.rbegin(), position.rend()}};
    }
};

/// The number of samples before the force leaves its rest for good (three samples), or nothing.
std::size_t restLength(const Channels& channels, const ContactForce& limits)
{
    std::size_t above = 0;
    for (std::size_t i = 0; i < channels.force.size(); ++i) {
        above = channels.force[i] > limits.threshold ? above + 1 : 0;
        if (above == 3)
            return i - 2;
    }
    return 0;
}

/// The length of the motion in the air that the channels begin with; 0 when there is none.
std::size_t airLength(const Channels& channels, const ContactForce& limits)
{
    const std::size_t touch = restLength(channels, limits);
    if (touch < shortestRest)
        return 0;
    std::vector<double> contact;
    for (std::size_t i = touch; i < channels.force.size(); ++i) {
        if (channels.force[i] > limits.threshold)
            contact.push_back(channels.position[i]);
    }
    if (contact.size() < shortestSqueeze)
        return 0;
    const double range = quantile(contact, 0.99) - quantile(contact, 0.01);
    const double noise = whiteNoiseDeviation(channels.position);
    const double margin = std::max(6 * noise, positionMargin * range);
    const double place = channels.position[touch];
    const double lowest = *std::min_element(contact.begin(), contact.end());
    const auto begin = channels.position.begin();
    const auto [shortest, farthest] = std::minmax_element(begin, begin + static_cast<std::ptrdiff_t>(touch));
    const bool isDivided = lowest >= place - margin && place - *shortest > smallestTravel * range;
    const bool comesFromFar = lowest - *shortest > range;
    const bool moves = place - *shortest > 10 * noise && *farthest <= place + margin;
    return moves && (isDivided || comesFromFar) ? touch : 0;
}

/// The force below which a squeeze has not begun or has ended, from the middle half of the contact.
double workingForce(std::span<const double> contact, double threshold)
{
    const std::span<const double> middle = contact.subspan(contact.size() / 4, (contact.size() + 1) / 2);
    const auto [low, high] = std::minmax_element(middle.begin(), middle.end());
    const double margin = std::max((*high - *low) / 4, 6 * whiteNoiseDeviation(contact));
    return std::max(*low - margin, threshold);
}

/// Cuts the rise behind the touch, and the fall before the release.
void cutRamps(ContactPhases& phases, std::span<const double> force, std::size_t end, double threshold)
{
    const std::span<const double> contact = force.subspan(phases.touch, end - phases.touch);
    const double working = workingForce(contact, threshold);
    const auto isLoaded = [working](double value) { return value >= working; };
    const auto half = contact.begin() + static_cast<std::ptrdiff_t>(contact.size() / 2);
    std::size_t first = phases.touch, last = end;
    if (phases.hasApproach) {
        const auto loaded = std::find_if(contact.begin(), half, isLoaded);
        phases.loaded = phases.touch + static_cast<std::size_t>(loaded - contact.begin());
        // Where the working range begins at the threshold itself, a fall below it belongs to the squeeze.
        first = phases.loaded;
        if (working > threshold) {
            const auto lastBelow =
                std::find_if_not(std::make_reverse_iterator(half), contact.rend(), isLoaded);
            first = std::max(first, phases.touch + static_cast<std::size_t>(contact.rend() - lastBelow));
        }
    }
    if (phases.hasRelease && working > threshold)
        last = phases.touch +
               static_cast<std::size_t>(std::find_if_not(half, contact.end(), isLoaded) - contact.begin());
    if (last >= first + shortestSqueeze)
        phases.squeeze = {first, last - first};
    else
        phases.loaded = phases.touch;
}

bool goAgainstEachOther(std::span<const double> force, std::span<const double> position)
{
    double forces = 0, positions = 0, sum = 0;
    const auto count = static_cast<double>(force.size());
    for (std::size_t i = 0; i < force.size(); ++i) {
        forces += force[i] / count;
        positions += position[i] / count;
    }
    for (std::size_t i = 0; i < force.size(); ++i)
        sum += (force[i] - forces) * (position[i] - positions);
    return sum < 0;
}

constexpr std::size_t shortestLoss = 3;
constexpr std::size_t fewestLoaded = 20;
constexpr double smallestWay = 1; ///< of the positions' range under load

/// The position (sign taken out) below which the gripper is off the object.
double offObject(std::span<const double> force, std::span<const double> position, const ContactForce& limits)
{
    std::vector<double> loaded;
    for (std::size_t i = 0; i < force.size(); ++i) {
        if (limits.sign * force[i] > limits.threshold)
            loaded.push_back(limits.sign * position[i]);
    }
    if (loaded.size() < fewestLoaded)
        return -1e308;
    const double low = quantile(loaded, 0.005), high = quantile(loaded, 0.995);
    return low - std::max(smallestWay * (high - low), 6 * whiteNoiseDeviation(position));
}

} // namespace

WindowChoice chooseWindow(const Recording& recording)
{
    WindowChoice choice;
    if (recording.size() == 0)
        return choice;
    const bool moving = hasMovingSamples(recording);
    const Window asked = moving ? movingSpan(recording) : Window{0, recording.size()};
    const std::size_t askedEnd = asked.first + asked.count;

    std::vector<bool> breaksBefore(recording.size(), false);
    for (const Gap& gap : findGaps(recording)) {
        breaksBefore[gap.before] = true;
        if (gap.before > asked.first && gap.before < askedEnd) {
            choice.lostSamples += gap.lostSamples;
            ++choice.gaps;
        }
    }

    Window current{asked.first, 0};
    for (std::size_t i = asked.first; i < askedEnd; ++i) {
        const bool wanted = !moving || isMoving(recording, i);
        if (breaksBefore[i] || !wanted)
            current = {i, 0};
        if (!wanted) {
            current.first = i + 1;
            continue;
        }
        ++choice.eligible;
        ++current.count;
        if (current.count > choice.window.count)
            choice.window = current;
    }
    return choice;
}

Window movingWindow(const Recording& recording)
{
    if (!hasMovingSamples(recording))
        return {0, recording.size()};
    Window longest, current;
    for (std::size_t i = 0; i < recording.size(); ++i) {
        current = isMoving(recording, i) ? Window{current.first, current.count + 1} : Window{i + 1, 0};
        if (current.count > longest.count)
            longest = current;
    }
    return longest;
}

ContactPhases findContact(std::span<const double> force, std::span<const double> position)
{
    ContactPhases phases;
    phases.squeeze = {0, force.size()};
    if (force.size() != position.size() || force.size() < shortestRest + shortestSqueeze)
        return phases;
    const ContactForce limits = contactForce(force);
    if (!limits.oneSided)
        return phases;
    Channels channels{{force.begin(), force.end()}, {position.begin(), position.end()}};
    for (std::size_t i = 0; i < force.size(); ++i) {
        channels.force[i] *= limits.sign;
        channels.position[i] *= limits.sign;
    }
    const std::size_t approach = airLength(channels, limits);
    const std::size_t opening = airLength(channels.reversed(), limits);
    phases.hasApproach = approach > 0;
    phases.hasRelease = opening > 0;
    phases.touch = phases.loaded = approach;
    const std::size_t end = force.size() - opening;
    phases.squeeze = {approach, end - approach};
    if (phases.hasApproach || phases.hasRelease)
        cutRamps(phases, channels.force, end, limits.threshold);
    return phases;
}

std::optional<ContactPhases> findOpening(std::span<const double> force, std::span<const double> position)
{
    std::vector<double> closing(position.begin(), position.end());
    for (double& x : closing)
        x = -x;
    const ContactPhases phases = findContact(force, closing);
    if (!phases.hasApproach)
        return std::nullopt;
    const std::size_t end = phases.squeeze.first + phases.squeeze.count;
    return goAgainstEachOther(force.subspan(phases.touch, end - phases.touch),
                              position.subspan(phases.touch, end - phases.touch))
               ? std::optional(phases)
               : std::nullopt;
}

std::vector<std::size_t> findContactLoss(std::span<const double> force, std::span<const double> position)
{
    std::vector<std::size_t> lost;
    if (force.size() != position.size() || force.empty())
        return lost;
    const ContactForce limits = contactForce(force);
    if (!limits.oneSided)
        return lost;
    const double off = offObject(force, position, limits);
    for (std::size_t i = 0; i < force.size();) {
        const std::size_t first = i;
        bool leaves = false;
        for (; i < force.size() && limits.sign * force[i] <= limits.threshold; ++i)
            leaves = leaves || limits.sign * position[i] < off;
        if (leaves && i - first >= shortestLoss) {
            const std::size_t from = first > 0 ? first - 1 : 0;
            const std::size_t to = std::min(i + 1, force.size());
            for (std::size_t n = std::max(from, lost.empty() ? 0 : lost.back() + 1); n < to; ++n)
                lost.push_back(n);
        }
        if (i == first)
            ++i;
    }
    return lost;
}

} // namespace gripscope
