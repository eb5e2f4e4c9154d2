// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/words.h"
#include "core/library/exchange/server_types.h"
#include "core/library/tables/audit_table.h"
#include "core/library/tables/person_table.h"

#include <algorithm>
#include <set>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

QString freeName(const std::vector<PersonRow>& people, const PersonRow& wanted)
{
    QString name = wanted.person.name;
    for (int number = 1; wanted.person.active && person_table::isNameTaken(people, name, wanted.person.id);
         ++number)
        name = number == 1 ? Words::tr("%1 (plant)").arg(wanted.person.name)
                           : Words::tr("%1 (plant, %2)").arg(wanted.person.name, QString::number(number));
    return name;
}

Expected<void> put(Database& station, PersonRow person, const RowStamp& stamp, const QString& place)
{
    ASSIGN_OR_RETURN(const auto people, person_table::all(station));
    const QString name = std::exchange(person.person.name, freeName(people, person));
    const auto before =
        std::ranges::find(people, person.person.id, [](const PersonRow& row) { return row.person.id; });
    person.version = 1;
    if (before != people.end()) {
        person.version = before->version + 1;
        // Wrong tries are counted for a secret: none of another's.
        person.secretVersion = std::max(
            person.secretVersion, before->secretVersion + (before->secretHash == person.secretHash ? 0 : 1));
    }
    RETURN_IF_ERROR(person_table::insert(station, person, stamp));
    QJsonObject details{
        {u"role"_s, toString(person.person.role)}, {u"active"_s, person.person.active}, {u"from"_s, place}};
    if (person.person.name != name)
        details[u"name_there"_s] = name;
    return audit_table::append(
        station, {QString::fromUtf16(audit_action::personTaken), person.person.name, {}, details, {}});
}

/// What the station changed itself is undone, where the two are not the same.
Expected<void> putAllAsAt(Database& there, Database& station, const QString& place)
{
    ASSIGN_OR_RETURN(const auto people, person_table::all(there));
    for (const PersonRow& person : people) {
        ASSIGN_OR_RETURN(const auto here, person_table::find(station, person.person.id));
        if (!here || here->person.role != person.person.role || here->person.active != person.person.active ||
            here->secretHash != person.secretHash)
            RETURN_IF_ERROR(put(station, person, RowStamp::now(), place));
    }
    return {};
}

Expected<bool> hasSupervisor(Database& database)
{
    ASSIGN_OR_RETURN(const auto people, person_table::all(database));
    return std::ranges::any_of(people, person_table::isActiveSupervisor, &PersonRow::person);
}

} // namespace

Expected<qint64> takeServerPeople(Database& there, const std::vector<Cell>& news, Database& station,
                                  const QString& place)
{
    const std::set<Cell> wanted(news.begin(), news.end());
    ASSIGN_OR_RETURN(const auto rows, person_table::everyRow(there));
    qint64 taken = 0;
    for (const auto& [stamp, person] : rows) {
        if (!wanted.contains(Cell(stamp.id)))
            continue;
        RETURN_IF_ERROR(put(station, person, stamp, place));
        ++taken;
    }
    if (taken > 0) {
        ASSIGN_OR_RETURN(const bool isAnyLeft, hasSupervisor(station));
        if (!isAnyLeft)
            RETURN_IF_ERROR(putAllAsAt(there, station, place));
    }
    return taken;
}

} // namespace gripscope
