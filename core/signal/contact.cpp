// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/signal/contact.h"

#include "core/signal/contact_force.h"
#include "core/signal/robust_statistics.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace gripscope {

namespace {

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

} // namespace

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

} // namespace gripscope
