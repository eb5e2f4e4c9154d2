// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/recognition/verdict/inspection_outcome.h"

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

InspectionOutcome outcomeByLimits(const std::optional<ConformityDecision>& conformity)
{
    switch (conformity.value_or(ConformityDecision::Conforms)) {
    case ConformityDecision::Conforms:
        break;
    case ConformityDecision::DoesNotConform:
        return InspectionOutcome::DoesNotConform;
    case ConformityDecision::TooNearTheLimit:
    case ConformityDecision::NotDecidable:
        return InspectionOutcome::Inconclusive;
    }
    return InspectionOutcome::AsExpected;
}

} // namespace

PartJudged::PartJudged(const Verdict& verdict)
    : kind(verdict.kind),
      conformity(verdict.conformity ? std::optional(verdict.conformity->decision) : std::nullopt)
{
}

std::optional<PartJudged> partJudgedFromString(const QString& text)
{
    const std::optional<VerdictKind> kind = verdictKindFromString(text.section(u' ', 0, 0));
    if (!kind)
        return {};
    return PartJudged{*kind, conformityDecisionFromString(text.section(u' ', 1))};
}

InspectionOutcome inspectionOutcome(const PartJudged& judged, const QString& type,
                                    const QString& expectedType)
{
    switch (judged.kind) {
    case VerdictKind::Type:
        return expectedType.isEmpty() || type == expectedType ? outcomeByLimits(judged.conformity)
                                                              : InspectionOutcome::OtherType;
    case VerdictKind::Unknown:
        return InspectionOutcome::Unknown;
    case VerdictKind::Inconclusive:
        return InspectionOutcome::Inconclusive;
    case VerdictKind::Invalid:
        break;
    }
    return InspectionOutcome::NotValid;
}

QString toString(InspectionOutcome outcome)
{
    switch (outcome) {
    case InspectionOutcome::AsExpected:
        return u"as_expected"_qs;
    case InspectionOutcome::OtherType:
        return u"other_type"_qs;
    case InspectionOutcome::Unknown:
        return u"unknown"_qs;
    case InspectionOutcome::Inconclusive:
        return u"inconclusive"_qs;
    case InspectionOutcome::NotValid:
        return u"not_valid"_qs;
    case InspectionOutcome::DoesNotConform:
        return u"does_not_conform"_qs;
    }
    return {};
}

} // namespace gripscope
