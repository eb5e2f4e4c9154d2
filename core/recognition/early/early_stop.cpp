// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/recognition/early/early_stop.h"

#include "core/base/words.h"
#include "core/recognition/types/predictive.h"
#include "core/recognition/verdict/quantity_text.h"

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <utility>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

EarlyDecisionOptions optionsFor(const EarlyStopSetup& setup)
{
    EarlyDecisionOptions options = setup.decision;
    options.statedError = std::min(setup.rates.falseReject, setup.rates.strangerAccept);
    options.otherTypes = setup.rates.wrongType;
    options.strangerShare = setup.rates.strangerShare;
    return options;
}

/// m, b and k that move in parallel with the object's.
Eigen::Vector3d gripperAlone(const MeasuringChain& chain)
{
    return chain.baseline ? Eigen::Vector3d(chain.baseline->parameters.data()) : Eigen::Vector3d::Zero();
}

/// Where strangers may be, in the channels' units; as the verdicts have it.
InstrumentRange rangeFor(const EarlyStopSetup& setup, const std::vector<CandidateType>& types)
{
    const std::optional<InstrumentRange> range = setup.rates.strangerRange();
    if (!range)
        return rangeAround(types);
    const Eigen::Vector3d gripper = gripperAlone(setup.chain);
    const Eigen::Vector3d lowest = range->lowest.vector() / setup.factor + gripper;
    const Eigen::Vector3d highest = range->highest.vector() / setup.factor + gripper;
    return {{lowest(0), lowest(1), lowest(2)}, {highest(0), highest(1), highest(2)}};
}

} // namespace

std::vector<CandidateType> candidateTypes(const EarlyStopSetup& setup)
{
    std::vector<CandidateType> candidates;
    const bool usable = setup.models && setup.factor > 0 && std::isfinite(setup.factor);
    // A record is followed by m, b and k alone; in other spaces nothing is decided early.
    if (!usable || setup.models->degreesOfFreedom < 3 || setup.models->space != QuantitySpace{})
        return candidates;
    const std::vector<TypeModel>& types = setup.models->types;
    const Eigen::Vector3d gripper = gripperAlone(setup.chain);
    const std::vector<TypePrediction> predictions =
        predictTypes(*setup.models, Eigen::Vector3d::Zero(), Eigen::Matrix3d(Eigen::Matrix3d::Zero()),
                     {setup.rates.robust});
    candidates.reserve(types.size());
    for (std::size_t i = 0; i < types.size(); ++i) {
        const Eigen::Vector3d object = types[i].meanLog.array().exp() / setup.factor;
        const Eigen::Vector3d measured = object + gripper;
        // Of a relative change of the object's, this much arrives in what is measured.
        const Eigen::Vector3d share = object.cwiseQuotient(measured);
        const double v = std::max(3.0, predictions[i].degreesOfFreedom);
        const Eigen::Matrix3d covariance =
            v / (v - 2) * predictions[i].covariance + types[i].meanCovarianceLog;
        candidates.push_back(
            {types[i].name, measured.array().log(), share.asDiagonal() * covariance * share.asDiagonal()});
    }
    return candidates;
}

EarlyStop::EarlyStop(EarlyStopSetup setup)
    : m_setup(std::move(setup)), m_possible(false), m_decider({}, {}, optionsFor(m_setup))
{
    const std::vector<CandidateType> types = candidateTypes(m_setup);
    m_possible = !types.empty();
    if (m_possible)
        m_decider = EarlyDecider(types, rangeFor(m_setup, types), optionsFor(m_setup));
}

bool EarlyStop::add(double force, double position)
{
    return m_possible && m_decider.add(force, position - m_setup.chain.frameCompliance * force);
}

bool EarlyStop::measuresEnough(const EarlyJudgement& judgement)
{
    if (!judgement.covarianceLog)
        return false;
    const Eigen::Vector3d deviations = judgement.covarianceLog->diagonal().cwiseSqrt();
    return deviations(0) <= largestLogDeviation && deviations(2) <= largestLogDeviation;
}

bool EarlyStop::verdictAgrees(const EarlyEnd& end, const EarlyJudgement& judgement) const
{
    if (!judgement.parameters || !judgement.covarianceLog)
        return false;
    const Eigen::Vector3d measured = judgement.parameters->vector();
    const Eigen::Vector3d object = m_setup.factor * (measured - gripperAlone(m_setup.chain));
    const Eigen::Matrix3d covariance = m_setup.factor * measured.asDiagonal() * *judgement.covarianceLog *
                                       measured.asDiagonal() * m_setup.factor;
    const Verdict verdict =
        judge(*m_setup.models, {object(0), object(1), object(2)}, m_setup.rates, covariance);
    return verdict.kind == end.kind && verdict.type == end.type;
}

std::optional<EarlyEnd> EarlyStop::look()
{
    if (!m_possible)
        return {};
    const EarlyJudgement& judgement = m_decider.look();
    if (judgement.verdict == EarlyVerdict::Undecided)
        return {};
    EarlyEnd end;
    end.samples = judgement.samples;
    if (judgement.verdict == EarlyVerdict::Type) {
        end.kind = VerdictKind::Type;
        end.type = m_setup.models->types[*judgement.best].name;
    }
    end.posterior = judgement.best ? judgement.posterior[*judgement.best] : judgement.posterior.back();
    return measuresEnough(judgement) && verdictAgrees(end, judgement) ? std::optional(end) : std::nullopt;
}

namespace {

Finding answer(VerdictKind kind, const QString& type)
{
    return kind == VerdictKind::Type ? type : Words::say("unknown");
}

} // namespace

Verdict verdictOnEarlyEnd(Verdict verdict, const EarlyEnd& end, double decided_s)
{
    const Finding seconds = shortNumber(decided_s);
    if (verdict.kind == VerdictKind::Invalid) {
        verdict.reasons.push_back(Words::say("The squeeze had ended early, after %1 s.").arg(seconds));
        return verdict;
    }
    if (verdict.kind == end.kind && verdict.type == end.type) {
        verdict.reasons.push_back(Words::say("Decided after %1 s.").arg(seconds));
        return verdict;
    }
    const Finding decided = answer(end.kind, end.type);
    if (verdict.kind == VerdictKind::Inconclusive)
        verdict.reasons.insert(
            verdict.reasons.begin(),
            Words::say("The squeeze ended after %1 s as %2, but all that was recorded by then does "
                       "not show it.")
                .arg(seconds, decided));
    else
        verdict.reasons = {
            Words::say("The squeeze ended after %1 s as %2, but all that was recorded by then says %3.")
                .arg(seconds, decided, answer(verdict.kind, verdict.type)),
            Words::say("Squeeze it again.")};
    verdict.kind = VerdictKind::Inconclusive;
    verdict.type.clear();
    return verdict;
}

Finding inWords(const EarlyEnd& end, double decided_s)
{
    return Words::say("%1 after %2 s, posterior %3")
        .arg(end.kind == VerdictKind::Type ? end.type : Words::say("unknown"),
             Finding::number(decided_s, 'g', 6), Finding::number(end.posterior, 'g', 6));
}

} // namespace gripscope
