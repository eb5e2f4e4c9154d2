// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/words.h"
#include "core/math/robust_statistics.h"
#include "core/session/calibrate/measuring_sessions.h"

#include <algorithm>
#include <cmath>

namespace gripscope {

namespace {

/// A block moves so little that its mass need not be told: then spring and damper alone explain it.
Identification identifyBlock(const Recording& recording)
{
    Identification whole = identify(recording);
    if (whole.validity.verdict != ValidityVerdict::Invalid && whole.budget.parameters)
        return whole;
    IdentificationOptions options;
    options.estimators = {Estimator::Static};
    Identification still = identify(recording, options);
    return still.validity.verdict != ValidityVerdict::Invalid ? still : whole;
}

/// k of the block and the frame with its standard uncertainty, the empty gripper's own taken off.
std::optional<ValueWithError> stiffnessOf(const Identification& squeeze)
{
    const UncertaintyBudget& budget = squeeze.budget;
    if (budget.parameters)
        return ValueWithError{budget.parameters->k, budget.combined[2].standardUncertainty};
    for (const FurtherParameter& further : budget.further)
        if (further.parameter == MotionParameter::Stiffness) {
            const GripperBaseline own = squeeze.baseline.value_or(GripperBaseline());
            return ValueWithError{further.value - own.parameters[2],
                                  std::hypot(further.combined.standardUncertainty, own.standardErrors[2])};
        }
    return std::nullopt;
}

} // namespace

FrameSession::FrameSession(ConnectSession& connection, LibraryService& library)
    : JudgedSeries(connection, library)
{
}

Expected<void> FrameSession::start(const Recipe& recipe, int squeezes)
{
    return begin(recipe, squeezes);
}

void FrameSession::clear()
{
    JudgedSeries::clear();
    m_compliance.reset();
    m_problem.clear();
}

void FrameSession::judge(const Recording& recording)
{
    Recording whole = recording;
    whole.chain.frameCompliance = 0; // it is the frame itself that is looked for
    whole.chain.frameComplianceUncertainty = 0;
    judgeBy(identifyBlock, std::move(whole));
}

void FrameSession::conclude()
{
    std::vector<ValueWithError> found;
    for (const Identification& squeeze : squeezes()) {
        const std::optional<ValueWithError> k = stiffnessOf(squeeze);
        if (!k || !(k->value > 0) || !(k->standardError > 0) ||
            squeeze.validity.verdict == ValidityVerdict::Invalid) {
            const ValiditySummary why = summaryOf(squeeze.validity);
            m_problem = Words::tr("squeeze %1: %2")
                            .arg(found.size() + 1)
                            .arg(why.reasons.empty() ? Words::tr("no stiffness was found")
                                                     : why.reasons.front().describe());
            return;
        }
        const double compliance = 1 / k->value;
        found.push_back({compliance, k->standardError * compliance * compliance});
    }
    if (found.empty())
        return;
    const ValueWithError mean = pooledMean(found);
    m_compliance = FrameCompliance{mean.value, mean.standardError};
}

Expected<void> FrameSession::accept()
{
    if (state() != State::Measured || !m_compliance)
        return failure(ErrorCode::Usage,
                       {Words::tr("There is no compliance that was measured well enough to be used.")});
    MeasuringChain chain = connection().measuringChain();
    chain.frameCompliance = m_compliance->value;
    chain.frameComplianceUncertainty = m_compliance->standardError;
    return storeChain({serial(), connection().forceLag_s(), chain, operatorName(),
                       Words::tr("rigid block, %1 squeezes").arg(squeezes().size())});
}

} // namespace gripscope
