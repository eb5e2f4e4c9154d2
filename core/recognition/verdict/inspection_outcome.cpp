// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/recognition/verdict/inspection_outcome.h"

namespace gripscope {

using namespace Qt::StringLiterals;

InspectionOutcome inspectionOutcome(VerdictKind verdict, const QString& type, const QString& expectedType)
{
    switch (verdict) {
    case VerdictKind::Type:
        return expectedType.isEmpty() || type == expectedType ? InspectionOutcome::AsExpected
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
    }
    return {};
}

} // namespace gripscope
