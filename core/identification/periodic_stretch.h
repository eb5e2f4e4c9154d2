// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/signal/recording.h"

#include <cstddef>
#include <optional>
#include <span>

namespace gripscope {

/// The period of a force in whole samples, found from the force alone: the shortest lag at which the
/// normalised autocorrelation of the force, its trend taken out, has a peak as high as its highest, refined
/// by the lag at which the longest possible distance between periods fits best. Nothing when four periods
/// do not fit into the record, when the correlation from period to period is below 0.8 (noise of half the
/// signal's deviation), or when the force does not change. O(n log n).
[[nodiscard]] std::optional<std::size_t> findPeriod(std::span<const double> force);

/// The stretch in which the force repeats after `period` samples: the longest in which the change from one
/// period to the next is nowhere (over a period) much larger than is usual in the record; what precedes the
/// excitation (touch, preload) and follows it is left out. Empty when the force does not repeat.
[[nodiscard]] Window periodicStretch(std::span<const double> force, std::size_t period);

} // namespace gripscope
