// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/recognition/verdict/verdict.h"

#include <QMap>
#include <QString>

#include <cstdint>
#include <functional>
#include <vector>

namespace gripscope {

/// What was counted in one enrolment: so many cases, and how many of them were each thing by name.
struct EnrolmentTally {
    double cases = 0;
    QMap<QString, double> counts;
};

/// A share of all cases, with its standard error when the enrolments, not the cases, are independent:
///     s^2 = sum_e (count_e - share cases_e)^2 / (sum_e cases_e)^2   (Cochran, Sampling Techniques, 3rd ed.,
/// section 9A). A share of squeezes that share an enrolment is known less well than a binomial says.
struct ClusteredShare {
    double share = 0, standardError = 0;
    double count = 0;
};

struct StudyTally {
    int enrolments = 0;
    double cases = 0;
    QMap<QString, ClusteredShare> shares; ///< every name that any enrolment counted
};
[[nodiscard]] StudyTally pooled(const std::vector<EnrolmentTally>& enrolments);

/// `one(run)` for run = 0..runs-1, on so many threads (0: as many as the machine has). The results are in
/// the order of the runs, whatever the threads. `one` must not share anything that changes.
[[nodiscard]] std::vector<EnrolmentTally> tallyRuns(int runs, int threads,
                                                    const std::function<EnrolmentTally(int)>& one);

enum class ScenarioKind {
    KnownParts,       ///< the model's assumptions: four types far apart, all spread alike, Gaussian
    Promise,          ///< the same; counted is in how many enrolments the rate is kept
    Neighbours,       ///< the first two types 3.5 standard deviations apart
    Strangers,        ///< parts of no type, so many standard deviations from one
    TwiceTheSpread,   ///< one type with twice the standard deviations; only it is judged
    HeavyTails,       ///< squeezes follow Student's t with 5 degrees of freedom
    StrangersInRange, ///< parts of no type, evenly over a range that is hardly larger than the gates
    NoiseMismatch,    ///< enrolled at 95 % noise fit, judged at 85 %, everything identified from records
};
[[nodiscard]] QString toString(ScenarioKind kind); ///< "known_parts", "promise", ...

/// One row of the study: fresh enrolments of four types, and squeezes judged by each.
struct RecognitionScenario {
    ScenarioKind kind = ScenarioKind::KnownParts;
    int squeezes = 10; ///< a type
    /// falseReject is the stated rate of every row but Neighbours, where it is wrongType, and
    /// StrangersInRange, where it is strangerAccept.
    VerdictOptions options;
    double deviations = 0; ///< Strangers: from the mean of the first type, in random directions
    int judged = 100;      ///< squeezes an enrolment
    /// The scatter is not alike in m, b and k: deviations as 1 : 1.5 : 2 about axes that are turned at random
    /// for each enrolment, and so is the direction in which neighbours lie. 3.9 % are the root of the mean
    /// variance.
    bool unlikeScatter = false;
    /// What the squeezes determine. unlikeScatter is of m, b and k alone.
    QuantitySpace space = {};
    /// "known_parts-10-0.01", "heavy_tails-10-0.01-robust", "neighbours-3-0.01-unlike",
    /// "known_parts-10-0.01-k"
    [[nodiscard]] QString name() const;
    [[nodiscard]] double statedRate() const;
};

/// The Gaussian scenarios. Scatter of a squeeze: 3.9 % in each of m, b and k, or of what else is determined.
/// Counted for every judged squeeze:
///     type (its own), wrong_type, unknown, inconclusive; Promise: kept (a case is an enrolment, its rejected
///     share counted on 20,000 squeezes); Neighbours also oracle_posterior and oracle_rate, those who know
/// the true types and name one when its posterior is at least 1 - rate, or whenever that keeps the rate;
///     Strangers: accepted, named a type, and oracle_accepted, by one who knows the types and has the
/// chi-square gate. StrangersInRange: types 10 deviations apart, the range 5 beyond them; accepted.
[[nodiscard]] EnrolmentTally runScenario(const RecognitionScenario& scenario, std::uint64_t seed);

/// The same for NoiseMismatch: 400 samples 0.05 s apart, PRBS with 0.5 s bits, output error with x0, v0 and
/// offset free, each squeeze of a part whose m, b, k scatter by 3.9 %.
[[nodiscard]] EnrolmentTally runNoiseMismatch(const RecognitionScenario& scenario, std::uint64_t seed);

/// One more of what the verdict on a squeeze of `type` is.
void count(const Verdict& verdict, const QString& type, EnrolmentTally& tally);

} // namespace gripscope
