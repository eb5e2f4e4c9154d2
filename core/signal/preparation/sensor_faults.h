// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/signal/recording/recording.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <span>

namespace gripscope {

/// Samples that stand at the end of a channel's range though no status bit says so.
struct ClippedSamples {
    std::size_t atLowest = 0, atHighest = 0;
    [[nodiscard]] std::size_t total() const { return atLowest + atHighest; }
};

/// Counts the samples in runs that equal the largest (smallest) value exactly and that the signal entered at
/// speed: runs of three and more entered by more than two steps of its lattice and a millionth of its range;
/// on a lattice also runs of eight and more entered by two steps twice in a row. A signal that settles comes
/// to its end value slowly, and the top of a parabola that is eight samples wide is entered by one step:
/// these are not counted. Nothing is counted
/// - at an end that has not at least twice as many samples as the value next to it: what is cut off piles up
///   there, while noise thins out towards its extremes;
/// - at exactly zero: that is no rail, a one-sided force rests there;
/// - where fewer than half of the samples lie between the extremes and the others are free of noise: a step,
///   a ramp or a binary sequence stands at its levels by design;
/// - where a `drive`, the other channel, as long, stands still meanwhile (within a tenth of its range) and
/// the
///   signal came there in one step or came to rest: a slow gripper's part settles from one sample to the
///   next, and its counts hide the noise.
///
/// Noise alone hardly does this: where it spreads over many values, the extreme of N samples comes three
/// times in a row with about N^-2; where it spreads over few, it neither piles up nor enters by more than
/// two. O(N).
[[nodiscard]] ClippedSamples clippedSamples(std::span<const double> values, double latticeStep = 0,
                                            std::span<const double> drive = {});

/// Samples at the end of a sensor's range, by the device's word (status bits) and by their look
/// (clippedSamples()).
struct SaturatedChannel {
    std::size_t marked = 0;
    ClippedSamples look;
    [[nodiscard]] std::size_t count() const { return std::max(marked, look.total()); }
};
struct SaturatedSamples {
    SaturatedChannel force, position;
};
[[nodiscard]] SaturatedSamples saturatedSamples(const Recording& recording, Window window);

/// The stretch over which `channel` stands at one value exactly although `drive`, the other channel, moves:
/// a sensor that sends no news. Nothing where it is not certain. O(N).
///
/// The drive moves where its range is more than 20 standard deviations of its noise and at least a fifth of
/// the stretch lies on either side of the middle of that range (noise on a coarse converter leaves its level
/// more rarely, or shows as noise). A channel that never changes then is stuck. Else the longest run of equal
/// values is held against the rest of the record. With q the share of neighbours there that are equal, a run
/// of n or more begins somewhere by chance with less than N q^n: that must be below 1e-9. It must also be ten
/// times as long as the next longest (coarse steps and a slow object make many long runs, a sensor gets stuck
/// once), at least 20 samples and a twentieth of all, and the drive must move meanwhile (what a constant
/// force holds stands still).
[[nodiscard]] std::optional<Window> stuckStretch(std::span<const double> channel,
                                                 std::span<const double> drive);

} // namespace gripscope
