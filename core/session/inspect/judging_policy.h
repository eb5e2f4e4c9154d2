// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/recognition/verdict/verdict.h"

namespace gripscope {

/// What is refused by choice, though it could be judged.
struct JudgingPolicy {
    bool calibrationOverdue = false; ///< of a channel, on the day of the squeeze
    /// Share of a squeeze's samples; 0: no limit but the one beyond which no measurement is valid.
    double mostLostShare = 0;
    bool nobodySignedIn = false; ///< set while nobody is, and somebody should be
    friend bool operator==(const JudgingPolicy&, const JudgingPolicy&) = default;
};

/// Why the policy refuses to judge this squeeze, and what to do, a sentence each; none: it does not.
[[nodiscard]] Findings refusals(const JudgingPolicy& policy, const Recording& recording,
                                const Identification& identification);
/// The verdict that is left then: Invalid for these reasons. What the measurement is worth stays as it is.
[[nodiscard]] Verdict refusedVerdict(const Verdict& verdict, Findings reasons);

} // namespace gripscope
