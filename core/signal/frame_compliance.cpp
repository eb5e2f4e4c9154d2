// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/signal/frame_compliance.h"

#include <algorithm>
#include <cmath>

namespace gripscope {

namespace {

/// The force `at` samples after the first one.
double forceAt(const std::vector<double>& force, double at, ForceHold hold)
{
    // A rest this close to a whole sample is rounding, not time.
    constexpr double rounding = 1e-9;
    const double last = static_cast<double>(force.size()) - 1;
    const double clamped = std::clamp(at, 0.0, last);
    const double whole = std::floor(clamped + rounding);
    const auto n = static_cast<std::size_t>(whole);
    const double rest = std::max(clamped - whole, 0.0);
    if (hold == ForceHold::Zero || rest <= rounding || n + 1 >= force.size())
        return force[n];
    return (1 - rest) * force[n] + rest * force[n + 1];
}

} // namespace

std::vector<double> withoutFrame(const std::vector<double>& position, const std::vector<double>& force,
                                 double compliance, double lag, ForceHold hold)
{
    std::vector<double> corrected = position;
    if (force.size() != position.size() || !std::isfinite(compliance) || !std::isfinite(lag))
        return corrected;
    for (std::size_t n = 0; n < corrected.size(); ++n) {
        const double x = position[n] - compliance * forceAt(force, static_cast<double>(n) + lag, hold);
        if (std::isfinite(x))
            corrected[n] = x;
    }
    return corrected;
}

} // namespace gripscope
