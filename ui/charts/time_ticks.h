// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <vector>

namespace gripscope {

struct TimeTick {
    double at = 0; ///< milliseconds since 1970, UTC
    QString label;
};

/// Round local times between two of them, at most `most`: minutes, hours, days, months or years apart. A
/// label says the time of day where they are less than a day apart, and the day at midnight.
[[nodiscard]] std::vector<TimeTick> timeTicks(double low_ms, double high_ms, int most);

} // namespace gripscope
