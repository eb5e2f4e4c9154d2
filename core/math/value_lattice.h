// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>

namespace gripscope {

/// The step of the lattice that all values lie on: what a converter or a rounded number leaves behind.
/// Euclid's greatest common divisor of the differences between neighbouring values, with room for rounding to
/// 1e-9 of the largest value. Nothing when there is none: fewer than 8 different values (two levels of a
/// commanded force are no quantisation), or a step below 1e-6 of the range, which no converter has and which
/// does no harm. O(N log N).
[[nodiscard]] std::optional<double> latticeStep(std::span<const double> values);

} // namespace gripscope
