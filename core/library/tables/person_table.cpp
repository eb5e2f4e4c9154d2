// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/tables/person_table.h"

#include "core/base/words.h"
#include "core/library/tables/serial.h"

#include <algorithm>

namespace gripscope::person_table {

using namespace Qt::StringLiterals;

namespace {

QString readingPeople()
{
    return Words::tr("read its people");
}

const auto selectPeople =
    u"SELECT p.id, p.station, p.created_utc, p.person_id, p.version, p.name, p.role, p.active, "
    "p.secret_hash, p.secret_version FROM people p"_s;

std::pair<RowStamp, PersonRow> takeRow(Statement& row)
{
    RowStamp stamp;
    stamp.id = row.takeText();
    stamp.station = row.takeText();
    stamp.utc = row.takeText();
    PersonRow found;
    found.person.since = QDateTime::fromString(stamp.utc, Qt::ISODateWithMs);
    found.person.id = row.takeText();
    found.version = int(row.takeInteger());
    found.person.name = row.takeText();
    found.person.role = roleFromString(row.takeText()).value_or(Role::Operator);
    found.person.active = row.takeInteger() != 0;
    found.secretHash = row.takeText();
    found.secretVersion = int(row.takeInteger());
    return {stamp, found};
}

} // namespace

Expected<void> insert(Database& database, const PersonRow& row, const RowStamp& stamp)
{
    Statement statement(
        database, Words::tr("store the person"),
        u"INSERT INTO people (id, station, created_utc, person_id, version, name, role, active, "
        "secret_hash, secret_version) VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?)"_s);
    statement.bind(stamp.id).bind(stamp.station).bind(stamp.utc);
    statement.bind(row.person.id).bind(row.version).bind(row.person.name).bind(toString(row.person.role));
    statement.bind(int(row.person.active)).bind(row.secretHash).bind(row.secretVersion);
    return statement.run();
}

Expected<bool> isAnybodyThere(Database& database)
{
    bool there = false;
    Statement query(database, readingPeople(), u"SELECT 1 FROM people LIMIT 1"_s);
    if (auto done = query.forEach([&](Statement&) { there = true; }); !done)
        return tl::unexpected(done.error());
    return there;
}

Expected<std::vector<std::pair<RowStamp, PersonRow>>> everyRow(Database& database)
{
    std::vector<std::pair<RowStamp, PersonRow>> rows;
    Statement query(database, readingPeople(), selectPeople + u" ORDER BY p.version, p.id"_s);
    const auto done = query.forEach([&](Statement& row) { rows.push_back(takeRow(row)); });
    if (!done)
        return tl::unexpected(done.error());
    return rows;
}

Expected<std::vector<PersonRow>> all(Database& database)
{
    std::vector<PersonRow> people;
    Statement query(database, readingPeople(),
                    selectPeople + u" WHERE p.version = "
                                   "(SELECT MAX(q.version) FROM people q WHERE q.person_id = p.person_id)"_s);
    const auto done = query.forEach([&](Statement& row) { people.push_back(takeRow(row).second); });
    if (!done)
        return tl::unexpected(done.error());
    std::sort(people.begin(), people.end(), [](const PersonRow& one, const PersonRow& other) {
        if (one.person.active != other.person.active)
            return one.person.active;
        return QString::localeAwareCompare(one.person.name, other.person.name) < 0;
    });
    return people;
}

bool isNameTaken(const std::vector<PersonRow>& people, const QString& name, const QString& exceptId)
{
    return std::ranges::any_of(people, [&](const PersonRow& row) {
        return row.person.active && row.person.id != exceptId &&
               row.person.name.compare(name, Qt::CaseInsensitive) == 0;
    });
}

bool isActiveSupervisor(const Person& person)
{
    return person.active && person.role == Role::Supervisor;
}

Expected<std::optional<PersonRow>> find(Database& database, const QString& personId)
{
    // A plant has tens of people: reading them all costs nothing.
    ASSIGN_OR_RETURN(auto people, all(database));
    const auto found = std::find_if(people.begin(), people.end(),
                                    [&](const PersonRow& row) { return row.person.id == personId; });
    return found == people.end() ? std::nullopt : std::optional(std::move(*found));
}

Expected<void> insertTry(Database& database, const PersonRow& row, bool right)
{
    const RowStamp stamp = RowStamp::now();
    Statement statement(database, Words::tr("note the try to sign in"),
                        u"INSERT INTO sign_in_tries (id, station, created_utc, person_id, secret_version, "
                        "outcome, serial) VALUES (?, ?, ?, ?, ?, ?, "_s +
                            nextSerial(u"sign_in_tries"_s) + u')');
    statement.bind(stamp.id).bind(stamp.station).bind(stamp.utc).bind(row.person.id).bind(row.secretVersion);
    return statement.bind(right ? u"right"_s : u"tried"_s).run();
}

Expected<SignInTries> tries(Database& database, const PersonRow& row)
{
    SignInTries tries;
    Statement query(
        database, readingPeople(),
        u"SELECT outcome, created_utc FROM sign_in_tries WHERE person_id = ? AND secret_version = ? "
        "ORDER BY "_s +
            newestFirst + u" LIMIT 100"_s);
    bool ended = false;
    const auto done = query.bind(row.person.id).bind(row.secretVersion).forEach([&](Statement& each) {
        ended = ended || each.takeText() == "right"_L1;
        if (ended)
            return;
        if (tries.wrong++ == 0)
            tries.last = each.takeUtc();
    });
    if (!done)
        return tl::unexpected(done.error());
    return tries;
}

} // namespace gripscope::person_table
