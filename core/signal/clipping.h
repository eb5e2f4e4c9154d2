// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>

namespace gripscope {

/// Samples that stand at the end of a channel's range though no status bit says so.
struct ClippedSamples {
    std::size_t atLowest = 0, atHighest = 0;
    [[nodiscard]] std::size_t total() const { return atLowest + atHighest; }
};

/// Counts the samples in runs of three and more that equal the largest (smallest) value exactly and that the
/// signal entered at speed: by more than two steps of its lattice and a millionth of its range. A signal that
/// settles comes to its end value slowly and is not counted. Nothing is counted where fewer than half of the
/// samples lie between the extremes: a step or a binary sequence stands at its levels by design. An end at
/// exactly zero is no rail: a one-sided force rests there. O(N).
[[nodiscard]] ClippedSamples clippedSamples(std::span<const double> values, double latticeStep = 0);

} // namespace gripscope
