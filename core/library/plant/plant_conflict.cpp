// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/plant/plant_conflict.h"

#include "core/base/words.h"

#include <algorithm>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

using Kind = PlantConflict::Kind;

/// "by Ada on hall-1".
QString whoAndWhere(const ChangeStamp& stamp)
{
    return stamp.person.isEmpty() ? Words::tr("on %1").arg(stamp.station)
                                  : Words::tr("by %1 on %2").arg(stamp.person, stamp.station);
}

QString statusInWords(const QString& status)
{
    switch (typeStatusFromString(status).value_or(TypeStatus::Gone)) {
    case TypeStatus::Enrolled:
        return Words::tr("waiting for approval");
    case TypeStatus::Approved:
        return Words::tr("approved");
    case TypeStatus::Retired:
        return Words::tr("retired");
    case TypeStatus::Gone:
        break;
    }
    return Words::tr("given up");
}

QString valueInWords(Kind kind, const QString& value)
{
    switch (kind) {
    case Kind::Status:
        return statusInWords(value);
    case Kind::Recipe:
        return Words::tr("the recipe");
    default:
        return value.isEmpty() ? Words::tr("none") : Words::tr("'%1'").arg(value);
    }
}

QString sideInWords(Kind kind, const PlantConflict::Side& side)
{
    return Words::tr("%1 %2").arg(valueInWords(kind, side.value), whoAndWhere(side.stamp));
}

QString what(const PlantConflict& conflict)
{
    switch (conflict.kind) {
    case Kind::Name:
        return Words::tr("Stations renamed %1 while apart").arg(conflict.type);
    case Kind::Status:
        return Words::tr("Stations decided apart whether %1 is recognised").arg(conflict.type);
    case Kind::Recipe:
        return Words::tr("Stations changed the recipe of %1 while apart").arg(conflict.type);
    case Kind::Code:
        return Words::tr("Stations gave %1 a code for scanners while apart").arg(conflict.type);
    default:
        return Words::tr("Stations set tolerance limits of %1 while apart").arg(conflict.type);
    }
}

} // namespace

QString toString(Kind kind)
{
    switch (kind) {
    case Kind::Name:
        return u"name"_s;
    case Kind::Status:
        return u"status"_s;
    case Kind::Recipe:
        return u"recipe"_s;
    case Kind::Code:
        return u"code"_s;
    case Kind::Limits:
        return u"limits"_s;
    case Kind::SameName:
        return u"same_name"_s;
    case Kind::SameCode:
        return u"same_code"_s;
    case Kind::Approval:
        return u"approval"_s;
    case Kind::GivenUp:
        return u"given_up"_s;
    }
    return {};
}

QString PlantConflict::id() const
{
    QStringList rows{inForce.stamp.row};
    for (const Side& side : onRecord)
        rows += side.stamp.row;
    std::sort(rows.begin(), rows.end());
    return toString(kind) + u' ' + typeId + u' ' + rows.join(u' ');
}

QString inWords(const PlantConflict& conflict)
{
    QStringList others;
    for (const PlantConflict::Side& side : conflict.onRecord)
        others += sideInWords(conflict.kind, side);
    const QString record = others.join(u", "_s);
    switch (conflict.kind) {
    case Kind::SameName:
        return Words::tr(
                   "Two types were called '%1': the one %2 keeps the name, and the one %3 is now called "
                   "'%4'. Rename or merge them where they are the same part.")
            .arg(conflict.inForce.value, whoAndWhere(conflict.inForce.stamp),
                 whoAndWhere(conflict.onRecord.front().stamp), conflict.type);
    case Kind::SameCode:
        return Words::tr(
                   "Two types were given the code %1: the one %2 keeps it, and %3 has none now. Give it "
                   "another.")
            .arg(conflict.inForce.value, whoAndWhere(conflict.inForce.stamp), conflict.type);
    case Kind::Approval:
        return Words::tr("%1 was approved %2 while it was changed %3: it waits for approval again.")
            .arg(conflict.type, whoAndWhere(conflict.onRecord.front().stamp),
                 whoAndWhere(conflict.inForce.stamp));
    case Kind::GivenUp:
        return Words::tr("%1 was given up %2 while squeezes of it were kept elsewhere: it is retired. Put it "
                         "back into use or merge it.")
            .arg(conflict.type, whoAndWhere(conflict.onRecord.front().stamp));
    default:
        return Words::tr("%1: %2 (later) is in force; %3 is on record. Change it where that is wrong.")
            .arg(what(conflict), sideInWords(conflict.kind, conflict.inForce), record);
    }
}

} // namespace gripscope
