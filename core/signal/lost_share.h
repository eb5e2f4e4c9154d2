// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/signal/recording.h"

#include <cstdint>
#include <span>

namespace gripscope {

/// The samples to keep so that at most `largestShare` of the grid they span is lost: all of them where that
/// holds; else the window with the largest measured - lost (1 - largestShare) / largestShare, which keeps as
/// many samples as it can and never exceeds the share (maximum-sum interval, Bentley 1984). `index` are the
/// samples' places on the grid, increasing; `largestShare` is above 0 and below 1. O(N).
[[nodiscard]] Window keepLostShare(std::span<const std::int64_t> index, double largestShare);

} // namespace gripscope
