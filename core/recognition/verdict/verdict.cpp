// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/recognition/verdict/verdict.h"

#include "core/base/words.h"
#include "core/recognition/types/squeeze_values.h"
#include "core/recognition/verdict/judgement.h"
#include "core/recognition/verdict/transfer.h"
#include "core/recognition/verdict/verdict_reasons.h"

#include <iterator>
#include <utility>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

constexpr double leastRate = 1e-6; ///< beyond it tails of a distribution are only belief
constexpr double mostRate = 0.5;
constexpr double leastConfidence = 0.5, mostConfidence = 0.9999;

/// Nothing is known of how squeezes differ: the nearest in plain logarithms, and no more.
Verdict withoutScatter(const TypeModels& models, const LogVector& log)
{
    Verdict verdict;
    verdict.kind = VerdictKind::Inconclusive;
    verdict.reasons = noGateReasons(models);
    double least = 0;
    for (const TypeModel& type : models.types) {
        const double distance = (log - type.meanLog).squaredNorm();
        if (verdict.nearest.isEmpty() || distance < least) {
            least = distance;
            verdict.nearest = type.name;
        }
        verdict.posterior.insert(type.name, 1.0 / double(models.types.size()));
    }
    return verdict;
}

Verdict judgeAt(const TypeModels& models, const LogVector& log, const std::optional<LogMatrix>& noise,
                const VerdictOptions& options)
{
    Verdict verdict = models.degreesOfFreedom == 0 ? withoutScatter(models, log)
                                                   : Judgement(models, log, noise, options).verdict();
    if (!models.types.empty())
        for (Finding& reason : spaceReasons(models))
            verdict.reasons.push_back(std::move(reason));
    return verdict;
}

} // namespace

QString toString(VerdictKind kind)
{
    switch (kind) {
    case VerdictKind::Type:
        return u"type"_s;
    case VerdictKind::Unknown:
        return u"unknown"_s;
    case VerdictKind::Inconclusive:
        return u"inconclusive"_s;
    case VerdictKind::Invalid:
        return u"invalid"_s;
    }
    return {};
}

std::optional<VerdictKind> verdictKindFromString(const QString& text)
{
    for (VerdictKind kind :
         {VerdictKind::Type, VerdictKind::Unknown, VerdictKind::Inconclusive, VerdictKind::Invalid})
        if (toString(kind) == text)
            return kind;
    return {};
}

Findings Verdict::allReasons() const
{
    Findings all = reasons;
    if (conformity)
        all.push_back(inWords(*conformity));
    if (validity.verdict == ValidityVerdict::Suspect)
        for (const Finding& reason : validity.reasons)
            all.push_back(Words::say("Suspect measurement: %1").arg(reason));
    return all;
}

std::optional<InstrumentRange> VerdictOptions::strangerRange() const
{
    return range || !siUnits ? range : InstrumentRange{};
}

std::optional<Error> VerdictOptions::validate() const
{
    const auto check = [](const QString& name, double rate) -> std::optional<Error> {
        if (rate >= leastRate && rate <= mostRate)
            return {};
        return Error{ErrorCode::Usage,
                     {Words::say("The rate %1 must be between %2 and %3, not %4.")
                          .arg(name)
                          .arg(leastRate)
                          .arg(mostRate)
                          .arg(rate)}};
    };
    if (auto problem = check(u"false-reject"_s, falseReject))
        return problem;
    if (auto problem = check(u"wrong-type"_s, wrongType))
        return problem;
    if (auto problem = check(u"stranger-accept"_s, strangerAccept))
        return problem;
    if (confidence && !(*confidence >= leastConfidence && *confidence <= mostConfidence))
        return Error{ErrorCode::Usage,
                     {Words::say("The confidence must be between %1 and %2, not %3.")
                          .arg(leastConfidence)
                          .arg(mostConfidence)
                          .arg(*confidence)}};
    const QuantitySpace all{{std::begin(allQuantities), std::end(allQuantities)}};
    if (range && !range->logVolume(all))
        return Error{
            ErrorCode::Usage,
            {Words::say("The instrument's range must have lowest values above zero and below the highest.")}};
    return {};
}

Verdict judge(const TypeModels& models, const TypeSqueeze& squeeze, const VerdictOptions& options)
{
    const std::optional<LogVector> log = coordinatesOf(squeeze, models.space);
    if (log)
        return judgeAt(models, *log, noiseOf(squeeze, models.space), options);
    Verdict verdict;
    verdict.reasons = {missingReason(squeeze, models.space)};
    verdict.validity.verdict = ValidityVerdict::Invalid;
    return verdict;
}

Verdict judge(const TypeModels& models, const MassDampingStiffness& parameters, const VerdictOptions& options,
              const std::optional<Eigen::Matrix3d>& covariance)
{
    return judge(models, TypeSqueeze{{}, parameters, covariance}, options);
}

Verdict judge(const TypeModels& models, const Identification& identification,
              const std::optional<TypeSqueeze>& found, const VerdictOptions& options,
              const std::optional<CommonShift>& transfer)
{
    return verdictOnMeasurement(identification, found, transfer,
                                [&](const TypeSqueeze& squeeze) { return judge(models, squeeze, options); });
}

Verdict verdictOnMeasurement(const Identification& identification, const std::optional<TypeSqueeze>& found,
                             const std::optional<CommonShift>& transfer, const SqueezeJudge& judgeSqueeze)
{
    Verdict verdict;
    if (identification.validity.verdict == ValidityVerdict::Invalid || !found)
        verdict.reasons = invalidReasons(identification);
    else
        verdict = judgeSqueeze(transfer ? adjusted(*found, *transfer) : *found);
    verdict.validity = summaryOf(identification.validity);
    if (verdict.kind == VerdictKind::Invalid)
        verdict.validity.verdict = ValidityVerdict::Invalid;
    verdict.samplesUsed = identification.choice.window.count;
    return verdict;
}

std::vector<GateIntervals> gateIntervals(const TypeModels& models, const VerdictOptions& options)
{
    if (models.degreesOfFreedom == 0 || models.types.empty())
        return {};
    const LogVector& any = models.types.front().meanLog; // a gate is the same from anywhere
    const std::optional<LogMatrix> likeEnrolled;
    return Judgement(models, any, likeEnrolled, options).gateIntervals();
}

int leaveOneOutCorrect(const std::vector<TypeSqueeze>& squeezes, const VerdictOptions& options)
{
    const QuantitySpace space = spaceOf(squeezes);
    int correct = 0;
    for (std::size_t left = 0; left < squeezes.size(); ++left) {
        std::vector<TypeSqueeze> others = squeezes;
        others.erase(others.begin() + std::ptrdiff_t(left));
        const Verdict verdict = judge(fitTypeModels(others, space), squeezes[left], options);
        correct += verdict.kind == VerdictKind::Type && verdict.type == squeezes[left].type;
    }
    return correct;
}

} // namespace gripscope
