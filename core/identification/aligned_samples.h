// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/scaled_record.h"

#include <algorithm>
#include <cstdlib>

namespace gripscope {

/// Position and force at the same time index, the lag rounded to whole samples.
struct AlignedSamples {
    const ScaledRecord& record;
    std::ptrdiff_t shift, count;

    explicit AlignedSamples(const ScaledRecord& r)
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

} // namespace gripscope
