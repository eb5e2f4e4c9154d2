// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/recognition/early/early_decision.h"

#include <cstdint>
#include <functional>
#include <vector>

namespace gripscope {

/// Squeezes with known truth, to be decided early: the four types of the paper's appendix (without units),
/// strangers among them, a PRBS with bits of 0.5 s and peak 1, samples 0.05 s apart, force held.
struct EarlyDecisionSetting {
    double fitPercent = 90; ///< of the true model over the longest squeeze: the noise
    double noisePole = 0;   ///< of first-order autoregressive position noise
    bool restKnown = false; ///< start at rest, no offset, and the program knows; else all are free and drawn
    std::size_t longest = 400;          ///< samples
    double scatter = 0.039;             ///< of ln m, ln b, ln k between squeezes of one type
    int enrolled = 10;                  ///< squeezes a type
    bool colouredNoise = true;          ///< the program allows for a pole
    [[nodiscard]] QString name() const; ///< "rest-90-white", "free-95-0.8"
};

/// Start known or free, 90 and 95 % noise fit, white noise and a pole of 0.8: eight.
[[nodiscard]] std::vector<EarlyDecisionSetting> earlyDecisionSettings();

struct EarlyDecisionStudyOptions {
    EarlyDecisionSetting setting;
    double statedError = 0.01;
    double strangerShare = 0.1;
    int runs = 2000;
    std::uint64_t seed = 1;
    int threads = 0; ///< 0: as many as the machine has
    std::function<void(std::int64_t, std::int64_t)> progress;
};

struct EarlyDecisionStudy {
    EarlyDecisionSetting setting;
    int runs = 0, strangers = 0;
    int decided = 0, wrong = 0; ///< wrong of those decided
    int strangersAccepted = 0;  ///< decided to be a type
    int knownCalledStrangers = 0, wrongTypes = 0;
    double meanSamples = 0;                             ///< undecided squeezes at the longest
    double medianSamples = 0, ninetyPercentSamples = 0; ///< quantiles
    /// Wrong when the undecided take the likeliest at the end.
    int wrongWhenForced = 0;
    /// The shortest fixed length at which the likeliest is wrong no more often than that, over the mean: how
    /// many times fewer samples. Empty: no length up to the longest is as good.
    std::optional<std::size_t> equalFixedLength;
    std::optional<double> saving;
};

/// The likeliest at every length, and the first length at which it is decided, of many squeezes. The draws of
/// a run depend on the seed and the run's number alone.
[[nodiscard]] EarlyDecisionStudy studyEarlyDecisions(const EarlyDecisionStudyOptions& options);

} // namespace gripscope
