// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <span>

namespace gripscope {

/// The least number of samples at rest that tell the noise of the force channel: a fifth of its deviation.
inline constexpr std::size_t leastRestingSamples = 20;

/// Standard deviation of white noise on a force channel while the gripper rests or closes on nothing: half
/// the mean square of the differences between neighbours, which a drift of the zero hardly enters (von
/// Neumann 1941). Relative standard error sqrt(3 / (4 N)). Nothing from fewer than leastRestingSamples, from
/// a force that does not rest (its variance more than twice that), or from one that stands still but for a
/// few steps of its converter (under half the differences other than zero).
[[nodiscard]] std::optional<double> restingForceNoise(std::span<const double> force);

} // namespace gripscope
