// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <cstddef>

namespace gripscope {

/// A lag of the position channel split into whole samples and a rest of less than one: the position with
/// index n is that at the force's time index n + samples + rest, 0 <= rest < 1. Negative lags have negative
/// `samples`.
struct LagAlignment {
    std::ptrdiff_t samples = 0;
    double rest = 0;

    LagAlignment() = default;
    LagAlignment(double lag_s, double sampleTime_s)
    {
        // A rest this close to a whole sample is rounding of the division, not time.
        constexpr double rounding = 1e-9;
        const double lag = sampleTime_s > 0 ? lag_s / sampleTime_s : 0;
        if (std::isnan(lag))
            return;
        // Longer than any record, whole or not.
        constexpr double longest = 1e15;
        if (std::abs(lag) > longest) {
            samples = static_cast<std::ptrdiff_t>(std::copysign(longest, lag));
            return;
        }
        const double whole = std::floor(lag + rounding);
        samples = static_cast<std::ptrdiff_t>(whole);
        rest = lag - whole > rounding ? lag - whole : 0;
    }
};

} // namespace gripscope
