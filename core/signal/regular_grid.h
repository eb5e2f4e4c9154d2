// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/signal/recording.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace gripscope {

/// Force and position on a regular grid of samples 0 .. N-1; at the indexes in `lost` (sorted) nothing was
/// measured, and the values there are a straight line between the neighbours, for plots only.
struct GriddedChannels {
    std::vector<double> force, position;
    std::vector<std::size_t> lost;
};

/// Puts each sample at its index, unchanged. `index` increases strictly; the grid goes from its first to its
/// last value, which the caller has found to be a size that fits. All three equally long.
[[nodiscard]] GriddedChannels placeOnGrid(std::span<const double> force, std::span<const double> position,
                                          std::span<const std::int64_t> index);

/// The same for samples taken off the grid, `time` in sample times (the grid's point n is at index[0] + n):
///
/// - Force: the function of time that the device's samples stand for (straight lines between them for a
///   first-order hold, steps for a zero-order one) is projected orthogonally on the functions that the grid
///   can hold (de Boor, A Practical Guide to Splines, ch. 14; for steps: the mean over each sample time). The
///   impulse over each sample time, and for straight lines its first moment too, is kept, so that an object
///   answers the same up to (omega T)^2 times the jitter. Measured against the exact response of can A to a
///   binary force with 10 % jitter: m within 0.02 % (first-order) and 0.07 % (zero-order) at omega T = 0.3,
///   where taking the samples as regular is off by 2.4 and 4 %.
/// - Position, which is smooth: the cubic through the four samples around (Lagrange). Its error at a distance
///   d from a sample is x'''' d T^3 / 12, for jumps of the acceleration a d T / 4 at the most.
///
/// Both act on each unbroken stretch alone as far as the force is concerned, so that nothing unknown leaks
/// into what was measured. A grid point counts as measured when it lies within a stretch or at most 0.3
/// sample times outside. A jitter above 0.2 is too large: points are lost, and neighbours change places.
[[nodiscard]] GriddedChannels resampleToGrid(std::span<const double> force, std::span<const double> position,
                                             std::span<const std::int64_t> index,
                                             std::span<const double> time, ForceHold hold);

} // namespace gripscope
