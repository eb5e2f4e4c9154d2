// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/recognition/early/early_decision.h"
#include "core/recognition/verdict/verdict.h"
#include "core/signal/recording/measuring_chain.h"

#include <QString>

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

namespace gripscope {

/// What it takes to end squeezes of known types early.
struct EarlyStopSetup {
    std::shared_ptr<const TypeModels> models;
    double factor = 1; ///< takes m, b, k from the channels' units to those of the models
    VerdictOptions rates;
    /// Sample time, hold, lag, what is free. The error, the share of other types and that of strangers are
    /// taken from `rates`.
    EarlyDecisionOptions decision;
    MeasuringChain chain = {}; ///< baseline and frame compliance count, in the channels' units
    friend bool operator==(const EarlyStopSetup&, const EarlyStopSetup&) = default;
};

/// The types as a squeeze of them will be, in the channels' units, the empty gripper in parallel: the scatter
/// without the noise of the enrolled squeezes (an EarlyDecider weighs this squeeze's own), widened by v/(v -
/// 2) for v degrees of freedom behind it and by the error of the type's mean. Empty with v < 3: nothing is
/// known of how squeezes differ.
[[nodiscard]] std::vector<CandidateType> candidateTypes(const EarlyStopSetup& setup);

/// Why a squeeze may end.
struct EarlyEnd {
    VerdictKind kind = VerdictKind::Unknown; ///< Type or Unknown
    QString type;                            ///< empty for Unknown
    double posterior = 0;
    std::size_t samples = 0; ///< it took
    friend bool operator==(const EarlyEnd&, const EarlyEnd&) = default;
};

/// Follows a squeeze and says when more of it would change nothing: when the sequential test has decided
/// (EarlyDecider) and the verdict on the estimate so far, with its covariance, is the same (judge()). The
/// second keeps a squeeze going whose type is plain but whose estimate is still too rough for the gates. Nor
/// does a squeeze end before its record would be a valid measurement.
///
/// A decision for a type leaves open at most the wrong-type rate for all others together; every decision at
/// most the smaller of the false-reject and the stranger-accept rate. A value; the same samples and looks
/// give the same end.
class EarlyStop {
public:
    explicit EarlyStop(EarlyStopSetup setup);

    /// False where the types say too little to decide anything: looks would be in vain.
    [[nodiscard]] bool possible() const { return m_possible; }
    /// As EarlyDecider::add(); true: it is time to look.
    bool add(double force, double position);
    /// Looks at all samples so far.
    [[nodiscard]] std::optional<EarlyEnd> look();

private:
    /// A record in which m or k is known no better than to a fourth would be no valid measurement (which asks
    /// for a half), or only just: few squeezes of one type alone decide as early as that.
    static constexpr double largestLogDeviation = 0.25;
    [[nodiscard]] static bool measuresEnough(const EarlyJudgement& judgement);
    [[nodiscard]] bool verdictAgrees(const EarlyEnd& end, const EarlyJudgement& judgement) const;

    EarlyStopSetup m_setup;
    bool m_possible;
    EarlyDecider m_decider;
};

/// How long squeezes will take.
struct EarlyTimes {
    int squeezes = 0, decided = 0; ///< simulated; those ended before their end
    double mean_s = 0;             ///< the undecided with their whole length
    double ninetyPercent_s = 0;    ///< nine of ten take no longer
};

/// By simulation of squeezes of the enrolled types in turn (24 at least, one of each of up to 100 types),
/// scattered as the types are, from rest, under `force` (the recipe's, in the channel's unit), with the
/// position noise that the enrolled squeezes' own covariances tell. Nothing where these are not known or
/// nothing can be decided. The same setup and force give the same times. Some tenths of a second of work for
/// four types.
[[nodiscard]] std::optional<EarlyTimes> expectedTimes(const EarlyStopSetup& setup,
                                                      const std::vector<double>& force);

/// The verdict on a squeeze that ended early, from the verdict on its record (judge()) and the decision that
/// ended it. Where the two agree it stands, and says when it was decided. Where they do not, the part is
/// neither: Inconclusive, and both answers are said. A measurement that is not valid stays that.
/// `decided_s`: from the start of the movement to the last sample the decision knew.
[[nodiscard]] Verdict verdictOnEarlyEnd(Verdict verdict, const EarlyEnd& end, double decided_s);

/// "A after 0.12 s, posterior 0.9996": for the record's provenance.
[[nodiscard]] Finding inWords(const EarlyEnd& end, double decided_s);

} // namespace gripscope
