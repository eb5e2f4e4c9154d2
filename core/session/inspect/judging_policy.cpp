// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/inspect/judging_policy.h"

#include "core/base/words.h"
#include "core/calibration/calibration_facts.h"

namespace gripscope {

namespace {

Finding overdueWords(const CalibrationFact& fact)
{
    const Finding words =
        fact.channel == SensorChannel::Force
            ? Words::say("Not judged: the calibration of the force was overdue by %1 days, and the settings "
                         "refuse that. Calibrate the force, then squeeze again.")
            : Words::say("Not judged: the calibration of the position was overdue by %1 days, and the "
                         "settings refuse that. Calibrate the position, then squeeze again.");
    return words.arg(-fact.daysLeft);
}

/// Of all samples of the squeeze.
double lostShare(const Identification& identification)
{
    const auto lost = static_cast<double>(identification.choice.lostSamples);
    const double whole = static_cast<double>(identification.choice.eligible) + lost;
    return whole > 0 ? lost / whole : 0;
}

} // namespace

Findings refusals(const JudgingPolicy& policy, const Recording& recording,
                  const Identification& identification)
{
    Findings reasons;
    if (policy.nobodySignedIn)
        reasons.push_back(Words::say("Not judged: nobody is signed in, and the settings ask for somebody. "
                                     "Sign in, then squeeze again."));
    if (policy.calibrationOverdue)
        for (const CalibrationFact& fact : calibrationFacts(recording.provenance))
            if (fact.daysLeft < 0)
                reasons.push_back(overdueWords(fact));
    const double lost = lostShare(identification);
    if (policy.mostLostShare > 0 && lost > policy.mostLostShare)
        reasons.push_back(Words::say("Not judged: %1 % of the samples were lost, and the settings allow %2 "
                                     "%. Look after cable and hub, then squeeze again.")
                              .arg(100 * lost, 'g', 2)
                              .arg(100 * policy.mostLostShare, 'g', 3));
    return reasons;
}

Verdict refusedVerdict(const Verdict& verdict, Findings reasons)
{
    Verdict refused;
    refused.samplesUsed = verdict.samplesUsed;
    refused.validity = verdict.validity;
    refused.reasons = std::move(reasons);
    return refused;
}

} // namespace gripscope
