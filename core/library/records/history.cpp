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

HistoryCounts& HistoryCounts::operator+=(const HistoryCounts& other)
{
    for (qint64 HistoryCounts::*count :
         {&HistoryCounts::inspections, &HistoryCounts::enrolled, &HistoryCounts::asExpected,
          &HistoryCounts::otherType, &HistoryCounts::unknown, &HistoryCounts::inconclusive,
          &HistoryCounts::notValid, &HistoryCounts::knownType, &HistoryCounts::unasked,
          &HistoryCounts::suspect, &HistoryCounts::voided, &HistoryCounts::doesNotConform})
        this->*count += other.*count;
    return *this;
}

std::optional<InspectionOutcome> HistoryEntry::outcome() const
{
    if (!verdict)
        return {};
    return inspectionOutcome({*verdict, conformity}, type, expectedType);
}

QString HistoryEntry::outcomeName() const
{
    const std::optional<InspectionOutcome> found = outcome();
    if (found == InspectionOutcome::AsExpected && expectedType.isEmpty())
        return u"known_type"_s;
    return found ? toString(*found) : QString();
}

QString HistoryEntry::numberText() const
{
    if (numberThere > 0)
        return u"%1-%2"_s.arg(station).arg(numberThere);
    return number > 0 ? QString::number(number) : QString();
}

QDateTime HistoryEntry::timeThere() const
{
    return utcOffset_s ? time.toOffsetFromUtc(int(*utcOffset_s)) : QDateTime();
}

bool HistoryEntry::suspect() const
{
    return validity == ValidityVerdict::Suspect && verdict && *verdict != VerdictKind::Invalid;
}

std::optional<double> HistoryEntry::tellingPosterior() const
{
    return verdict == VerdictKind::Type || verdict == VerdictKind::Inconclusive ? posterior : std::nullopt;
}

} // namespace gripscope
