// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/signal/recording.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace gripscope {

/// The force values at the grid points firstPoint .. firstPoint + count - 1 (one sample time apart) whose
/// held function is nearest, in the sense of least squares over time, to the held function of the samples
/// `force` at `time` (in sample times, increasing, no gaps).
///   First-order hold: straight lines on both sides; a tridiagonal system of the hat functions' products
///   (diagonal 2/3, sides 1/6), the end segments continued beyond the first and last sample.
///   Zero-order hold: the mean over each sample time.
/// No samples: zeros. O(samples + count).
[[nodiscard]] std::vector<double> projectForce(std::span<const double> force, std::span<const double> time,
                                               std::int64_t firstPoint, std::size_t count, ForceHold hold);

} // namespace gripscope
