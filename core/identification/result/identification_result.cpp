// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/result/identification_result.h"

#include <algorithm>

namespace gripscope {

namespace {

/// What fails because something else did.
bool isConsequence(const QString& id)
{
    return id == QLatin1String("excitation") || id == QLatin1String("convergence") ||
           id == QLatin1String("physical_range") || id == QLatin1String("fit");
}

} // namespace

QString toString(ValidityVerdict verdict)
{
    switch (verdict) {
    case ValidityVerdict::Valid:
        return QStringLiteral("valid");
    case ValidityVerdict::Suspect:
        return QStringLiteral("suspect");
    case ValidityVerdict::Invalid:
        return QStringLiteral("invalid");
    }
    return {};
}

std::optional<ValidityVerdict> validityVerdictFromString(const QString& text)
{
    for (const ValidityVerdict verdict :
         {ValidityVerdict::Valid, ValidityVerdict::Suspect, ValidityVerdict::Invalid})
        if (toString(verdict) == text)
            return verdict;
    return {};
}

ValiditySummary summaryOf(const Validity& validity)
{
    ValiditySummary summary;
    summary.verdict = validity.verdict;
    const bool decisive = validity.verdict == ValidityVerdict::Invalid;
    Findings consequences;
    for (const ValidityCheck& check : validity.checks) {
        if (check.ok)
            continue;
        summary.checksFailed << check.id;
        if (check.message.isEmpty() || check.decisive != decisive)
            continue;
        Findings& reasons = isConsequence(check.id) ? consequences : summary.reasons;
        if (const Finding sentence = check.message.asSentence();
            std::ranges::find(reasons, sentence) == reasons.end())
            reasons.push_back(sentence);
    }
    if (summary.reasons.empty())
        summary.reasons = consequences;
    return summary;
}

ValidityVerdict overallVerdict(const std::vector<ValidityCheck>& checks)
{
    ValidityVerdict verdict = ValidityVerdict::Valid;
    for (const ValidityCheck& check : checks) {
        if (check.ok)
            continue;
        if (check.decisive)
            return ValidityVerdict::Invalid;
        verdict = ValidityVerdict::Suspect;
    }
    return verdict;
}

const Estimate* Identification::find(Estimator estimator) const
{
    for (const Estimate& estimate : estimates) {
        if (estimate.estimator == estimator)
            return &estimate;
    }
    return nullptr;
}

const Estimate* Identification::best() const
{
    const Estimate* estimate = find(recommended);
    return estimate != nullptr && estimate->parameters ? estimate : nullptr;
}

const HoldEvidence& Identification::tellingHold() const
{
    const bool alone = holdEvidence.verdict() == HoldVerdict::Contradicts &&
                       summedHold.verdict() != HoldVerdict::Contradicts;
    return alone ? holdEvidence : summedHold;
}

std::optional<CorrectedParameters> Identification::object() const
{
    const Estimate* estimate = best();
    if (estimate == nullptr)
        return std::nullopt;
    const Eigen::Matrix3d covariance = estimate->covariance.value_or(Eigen::Matrix3d::Zero());
    if (baseline)
        return withoutGripper(*estimate->parameters, covariance, *baseline);
    return CorrectedParameters{*estimate->parameters, covariance};
}

} // namespace gripscope
