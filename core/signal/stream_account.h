// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/signal/recording.h"

namespace gripscope {

/// What befell the stream while a recording was made, between its first sample and its last.
struct StreamAccount {
    std::uint64_t lostSamples = 0;
    std::uint64_t gaps = 0; ///< places where they are missing
    std::uint64_t duplicateReports = 0;
    std::uint64_t badReports = 0; ///< wrong CRC, length or version
    std::uint64_t clockSteps = 0; ///< the device's clock jumped against its sample count
    std::uint64_t stalls = 0;     ///< nothing came for a while
    double longestStall_s = 0;
    friend bool operator==(const StreamAccount&, const StreamAccount&) = default;
};

/// It is kept in the recording's provenance under this key, so in the comment lines of its file and in the
/// library: `lost_samples=0 gaps=0 duplicate_reports=0 bad_reports=0 clock_steps=0 stalls=0
/// longest_stall_s=0`.
[[nodiscard]] QString streamAccountKey();
/// The key of a recording whose losses cannot be seen, and why; others do not have it.
[[nodiscard]] QString unseenLossesKey();
[[nodiscard]] QString toText(const StreamAccount& account);
/// Names that are not known are passed over, those that are missing are zero.
[[nodiscard]] StreamAccount streamAccountFromText(const QString& text);

/// What the recording says of its stream; nothing when it does not.
[[nodiscard]] std::optional<StreamAccount> streamAccount(const Recording& recording);

} // namespace gripscope
