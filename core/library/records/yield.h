// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QtGlobal>

#include <optional>

namespace gripscope {

/// The yield, wherever one is told: of the parts that were judged, the share that was as expected. A part is
/// judged when it is as expected, another type, beyond its limits or unknown. A squeeze that calls for
/// another one, not valid or inconclusive, judged nothing. A suspect one counts as what it was judged.
struct Yield {
    qint64 asExpected = 0, judged = 0;
    /// Of those judged, where nothing was expected: a known type counts there, and is not called as expected.
    qint64 unasked = 0;
    /// Nothing where nothing was judged.
    [[nodiscard]] std::optional<double> share() const
    {
        return judged > 0 ? std::optional(static_cast<double>(asExpected) / static_cast<double>(judged))
                          : std::nullopt;
    }
    friend bool operator==(const Yield&, const Yield&) = default;
};

/// Of whatever counts outcomes.
template <typename Counts>
[[nodiscard]] Yield yieldOf(const Counts& counts)
{
    return {counts.asExpected, counts.asExpected + counts.otherType + counts.unknown + counts.doesNotConform,
            counts.unasked};
}

} // namespace gripscope
