// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/finding.h"
#include "core/signal/recording/recording.h"

#include <cstddef>
#include <optional>

namespace gripscope {

/// What a recording may hold, wherever it comes from: a gripper, a file, a capture, a library. Whoever reads
/// numbers in refuses what is outside, so that whoever computes with them need not ask.

/// Twenty times finer and a hundred times coarser than any gripper measures.
inline constexpr double shortestSampleTime_s = 1e-6;
inline constexpr double longestSampleTime_s = 1;
/// Half an hour at 2 kHz, four minutes at 16 kHz; some 170 MB.
inline constexpr std::size_t mostSamples = 4'000'000;
/// Bytes: a row of as many samples as there may be has about so many.
inline constexpr long long largestRecordingFile = 64 * static_cast<long long>(mostSamples);
/// Of force, position and time: fourth powers and their sums are still numbers.
inline constexpr double largestReading = 1e30;
/// Of the position channel behind the force channel, either way.
inline constexpr double longestForceLag_s = 1;
/// Facts beside the samples (Recording::provenance).
inline constexpr qsizetype mostFacts = 1000;

[[nodiscard]] bool isSampleTime(double seconds); ///< false for NaN
[[nodiscard]] bool isReading(double value);      ///< finite and not above largestReading
[[nodiscard]] Finding sampleTimeExpectation();   ///< "seconds from 1e-06 to 1"

/// How many samples fill so many seconds, rounded; a count above mostSamples (and for times that make no
/// sense) is mostSamples + 1, which every user of it refuses.
[[nodiscard]] std::size_t samplesIn(double seconds, double sampleTime_s);

/// What of `recording` no recording has, in words; nothing where all is well. A recording without samples
/// may be without a sample time. O(N).
[[nodiscard]] std::optional<Finding> outOfRange(const Recording& recording);

} // namespace gripscope
