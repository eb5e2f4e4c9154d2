// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/signal/contact_loss.h"

#include "core/signal/contact_force.h"
#include "core/signal/robust_statistics.h"

#include <algorithm>

namespace gripscope {

namespace {

constexpr std::size_t shortestRun = 3;
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
        if (leaves && i - first >= shortestRun) {
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
