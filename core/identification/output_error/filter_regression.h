// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/output_error/output_error_problem.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <optional>

namespace gripscope {

/// Position and force at the same time index, the lag rounded to whole samples.
struct AlignedSamples {
    const OutputErrorProblem& record;
    std::ptrdiff_t shift, count;

    explicit AlignedSamples(const OutputErrorProblem& r)
        : record(r), shift(r.lag.samples + (r.lag.rest >= 0.5 ? 1 : 0)),
          count(static_cast<std::ptrdiff_t>(r.force.size()) - std::abs(shift))
    {
    }
    [[nodiscard]] double force(std::ptrdiff_t t) const
    {
        return record.force[static_cast<std::size_t>(t + std::max<std::ptrdiff_t>(shift, 0))];
    }
    [[nodiscard]] double position(std::ptrdiff_t t) const
    {
        return record.position[static_cast<std::size_t>(t + std::max<std::ptrdiff_t>(-shift, 0))];
    }
};

/// Bandwidths of the filters worth trying, in radians a sample.
inline constexpr std::array<double, 5> filterBandwidths{0.01, 0.03, 0.1, 0.3, 1.0};

/// M y'' + B y' + spring(y) = F, spring(y) = s[0] + s[1] y + s[2] y^2 + s[3] y^3, in the record's units.
struct FilterRegression {
    double mass = 0, damping = 0;
    std::array<double, 4> spring{};
};

/// Least squares on state-variable filters f = 1 / (1 + s/bandwidth)^2 of all terms (Young 1981), the
/// filters' own free responses as extra columns; s[0] for a free offset, s[3] for a cubic spring, s[2] for
/// both. The lag is rounded to whole samples. Biased by noise: a start. Nothing when it is not finite.
[[nodiscard]] std::optional<FilterRegression> filterRegression(const OutputErrorProblem& record,
                                                               double bandwidth, bool cubic);

} // namespace gripscope
