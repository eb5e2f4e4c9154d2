// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/finding.h"

#include <cstdint>
#include <optional>

namespace gripscope {

/// What a count of failures proves about their rate.
struct BinomialEvidence {
    std::int64_t failures = 0, trials = 0;
    double lowest = 0;  ///< the rate is at least this, with the confidence on this side alone
    double highest = 1; ///< and at most this, the same
};

/// One-sided exact bounds (Clopper and Pearson, Biometrika 1934): 0 of 30 is at most 9.5 % with 95 %
/// confidence. Failures beyond the trials, or negative numbers, count as no trials.
[[nodiscard]] BinomialEvidence binomialEvidence(std::int64_t failures, std::int64_t trials,
                                                double confidence = 0.95);

/// How many trials without a failure prove a rate of at most `rate`: 2,995 for 0.1 % with 95 % confidence.
/// Nothing for a rate or confidence that is not between 0 and 1, or beyond 1e15.
[[nodiscard]] std::optional<std::int64_t> trialsNeeded(double rate, double confidence = 0.95);

/// "0 wrong of 40: at most 7.2 % with 95 % confidence; 2,995 without one are needed to show 0.1 %."
[[nodiscard]] Finding inWords(const BinomialEvidence& evidence, double statedRate, double confidence = 0.95);

} // namespace gripscope
