// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/records/history.h"

namespace gripscope {

using namespace Qt::StringLiterals;

QString toString(SqueezeKind kind)
{
    return kind == SqueezeKind::Inspection ? u"inspection"_s : u"enrollment"_s;
}

bool HistoryQuery::everything() const
{
    HistoryQuery open;
    open.order = order;
    open.descending = descending;
    return *this == open;
}

std::optional<InspectionOutcome> HistoryEntry::outcome() const
{
    if (!verdict)
        return {};
    return inspectionOutcome(*verdict, type, expectedType);
}

std::optional<double> HistoryEntry::tellingPosterior() const
{
    return verdict == VerdictKind::Type || verdict == VerdictKind::Inconclusive ? posterior : std::nullopt;
}

} // namespace gripscope
