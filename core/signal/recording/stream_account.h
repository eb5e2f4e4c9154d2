// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/signal/recording/recording.h"

#include <cmath>
#include <optional>

namespace gripscope {

/// How much faster than the computer's time something ran, in parts in a million (slower: below zero), and
/// how far off that may be.
struct RateDifference {
    double ppm = 0;
    double uncertainty_ppm = 0;
    /// Whatever it is within its uncertainty, it is larger than `limit_ppm` either way.
    [[nodiscard]] bool beyond(double limit_ppm) const { return std::abs(ppm) - uncertainty_ppm > limit_ppm; }
    friend bool operator==(const RateDifference&, const RateDifference&) = default;
};

/// A device's time held against the computer's, over its connection up to now.
struct ClockAccount {
    /// The device's time runs beside the computer's; not that of a replay or of a simulation at its own
    /// speed.
    bool compared = false;
    std::optional<RateDifference> clock; ///< of its clock; nothing: too young a connection, or it jumps
    /// Of its samples, counted in the sample time that it states: above zero they come more often than that.
    std::optional<RateDifference> sampling;
    friend bool operator==(const ClockAccount&, const ClockAccount&) = default;
};

/// What befell the stream while a recording was made, between its first sample and its last.
struct StreamAccount {
    std::uint64_t lostSamples = 0;
    std::uint64_t gaps = 0; ///< places where they are missing
    std::uint64_t duplicateReports = 0;
    std::uint64_t badReports = 0; ///< wrong CRC, length or version
    std::uint64_t clockSteps = 0; ///< the device's clock jumped against its sample count
    std::uint64_t stalls = 0;     ///< nothing came for a while
    double longestStall_s = 0;
    ClockAccount clocks = {}; ///< as it was known at the end
    friend bool operator==(const StreamAccount&, const StreamAccount&) = default;
};

/// It is kept in the recording's provenance under this key, so in the comment lines of its file and in the
/// library: `lost_samples=0 gaps=0 duplicate_reports=0 bad_reports=0 clock_steps=0 stalls=0
/// longest_stall_s=0`; where clocks were compared also `clock_compared=1`, and as far as they are known
/// `clock_ppm=12 clock_uncertainty_ppm=80 sampling_ppm=12 sampling_uncertainty_ppm=80`.
[[nodiscard]] QString streamAccountKey();
/// The key of a recording whose losses cannot be seen, and why; others do not have it.
[[nodiscard]] QString unseenLossesKey();
[[nodiscard]] QString toText(const StreamAccount& account);
/// Names that are not known are passed over, those that are missing are zero.
[[nodiscard]] StreamAccount streamAccountFromText(const QString& text);

/// What the recording says of its stream; nothing when it does not.
[[nodiscard]] std::optional<StreamAccount> streamAccount(const Recording& recording);

} // namespace gripscope
