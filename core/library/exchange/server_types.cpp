// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/exchange/server_types.h"

#include "core/base/words.h"
#include "core/library/ledger/merged_ledger.h"
#include "core/library/merge/known_history.h"
#include "core/library/merge/meeting_table.h"
#include "core/library/merge/settlement.h"
#include "core/library/merge/taken_news.h"
#include "core/library/migrations/schema_check.h"
#include "core/library/sql/rows.h"
#include "core/library/tables/audit_table.h"
#include "core/library/tables/change_table.h"
#include "core/library/tables/placement_table.h"
#include "core/library/tables/type_state_table.h"

#include <algorithm>
#include <array>
#include <span>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

QString readingServer()
{
    return Words::tr("read the types of the server");
}

/// Which rows of a table the stations of a plant have in common.
struct CommonTable {
    QString name, where;
    bool marked = false; ///< it may change without a version of the library
};

std::span<const CommonTable> commonTables()
{
    static const QString ofTypes = u"grasp_id IN (SELECT id FROM grasps WHERE type_id IS NOT NULL)"_s;
    // A study stays apart, with the squeezes it keeps, unless a gripper was adjusted by it.
    static const QString adjusting = u"IN (SELECT study_id FROM gripper_adjustments)"_s;
    static const QString ofAdjusting = u"study_id "_s + adjusting;
    static const QString decided =
        u"version NOT IN (SELECT version FROM library_changes WHERE kind = '%1')"_s.arg(
            toString(ChangeKind::Meeting)); // the others follow from these
    static const std::vector<CommonTable> tables{
        {u"types"_s, {}},
        {u"type_versions"_s, {}},
        {u"library_changes"_s, u"kind <> '%1'"_s.arg(toString(ChangeKind::Meeting))},
        {u"type_states"_s, decided},
        {u"pictures"_s, u"id IN (SELECT picture_id FROM type_pictures)"_s},
        {u"type_pictures"_s, {}, true},
        {u"draft_squeezes"_s,
         u"id IN (SELECT draft_squeeze_id FROM recordings WHERE %1) OR "
         "id IN (SELECT squeeze_id FROM study_measurements WHERE %2)"_s.arg(ofTypes, ofAdjusting)},
        {u"grasps"_s, u"type_id IS NOT NULL"_s},
        {u"placements"_s, decided},
        {u"recordings"_s, ofTypes},
        {u"documents"_s, ofTypes},
        {u"estimates"_s, ofTypes},
        {u"reidentifications"_s, ofTypes},
        {u"determined_quantities"_s, ofTypes},
        {u"measuring_chains"_s, {}, true},
        {u"calibrations"_s, {}, true},
        {u"reference_objects"_s, {}, true},
        {u"reference_checks"_s, {}, true},
        {u"process_limits"_s, {}, true},
        {u"studies"_s, u"id "_s + adjusting},
        {u"study_ends"_s, ofAdjusting, true},
        {u"study_measurements"_s, ofAdjusting},
        {u"study_undos"_s,
         u"measurement_id IN (SELECT id FROM study_measurements WHERE %1)"_s.arg(ofAdjusting)},
        {u"gripper_adjustments"_s, {}, true},
        {u"adjustment_ends"_s, {}, true},
        {u"people"_s, {}, true},
    };
    return tables;
}

Expected<std::set<Cell>> keysOf(Database& database, const CommonTable& table)
{
    std::set<Cell> keys;
    const QString where = table.where.isEmpty() ? QString() : u" WHERE "_s + table.where;
    Statement query(database, readingServer(),
                    u"SELECT %1 FROM %2%3"_s.arg(ledgeredTable(table.name)->key, table.name, where));
    const auto done = query.forEach([&](Statement& row) { keys.insert(row.takeText()); });
    if (!done)
        return tl::unexpected(done.error());
    return keys;
}

/// Copies rows as they are. Nothing is named: all of them.
Expected<void> copyRows(Database& server, Database& copy, const QString& table,
                        const std::optional<std::vector<Cell>>& keys)
{
    const QString key = ledgeredTable(table)->key;
    ASSIGN_OR_RETURN(TableRows there, TableRows::of(server, table, key));
    ASSIGN_OR_RETURN(TableRows here, TableRows::of(copy, table, key));
    std::vector<Cell> wanted = keys.value_or(std::vector<Cell>());
    if (!keys) {
        ASSIGN_OR_RETURN(const auto all, keysOf(server, {table, {}}));
        wanted.assign(all.begin(), all.end());
    }
    ASSIGN_OR_RETURN(const auto found, there.withKeys(wanted));
    std::vector<TableRows::Row> rows;
    rows.reserve(found.size());
    for (const auto& [one, row] : found)
        rows.push_back(row);
    return here.insertAll(rows, readingServer());
}

/// What is in force, as the server itself has worked it out.
Expected<PlantState> plantStateAt(Database& server, qint64 version)
{
    std::map<std::pair<QString, int>, QString> recipes;
    Statement query(server, readingServer(), u"SELECT type_id, version, id FROM type_versions"_s);
    RETURN_IF_ERROR(query.forEach([&](Statement& row) {
        const QString type = row.takeText();
        const int number = int(row.takeInteger());
        recipes[{type, number}] = row.takeText();
    }));
    PlantState state;
    ASSIGN_OR_RETURN(const auto types, type_state_table::at(server, version));
    for (const TypeState& type : types)
        state.types[type.typeId] = {type.typeId, type.name,
                                    type.status, recipes[{type.typeId, type.recipeVersion}],
                                    type.code,   toText(type.limits)};
    ASSIGN_OR_RETURN(const auto squeezes, placement_table::at(server, version));
    for (const auto& [squeeze, place] : squeezes)
        state.squeezes[squeeze] = {place.typeId, place.accepted};
    return state;
}

Expected<std::shared_ptr<Database>> emptyCopy()
{
    ASSIGN_OR_RETURN(std::shared_ptr<Database> copy, Database::inMemory());
    RETURN_IF_ERROR(makeTables(*copy));
    // What rows point to may be at the station already, and is not copied then.
    RETURN_IF_ERROR(copy->execute(u"PRAGMA foreign_keys = OFF"_s, readingServer()));
    return copy;
}

} // namespace

Expected<QString> marksOf(Database& server)
{
    QStringList marks{u"(SELECT COALESCE(MAX(version), 0) FROM library_changes)"_s,
                      u"(SELECT COUNT(*) FROM conflicts_seen)"_s};
    for (const CommonTable& table : commonTables())
        if (table.marked)
            marks += u"(SELECT COALESCE(MAX(rowid), 0) FROM %1)"_s.arg(table.name);
    Statement query(server, readingServer(), u"SELECT "_s + marks.join(u" || ' ' || "_s));
    QString found;
    RETURN_IF_ERROR(query.forEach([&](Statement& row) { found = row.takeText(); }));
    return found;
}

Expected<ServerTypes> readServerTypes(Database& server, Database& station)
{
    ASSIGN_OR_RETURN(const auto oneState, ReadTransaction::begin(server, readingServer()));
    ServerTypes types;
    types.place = server.file();
    ASSIGN_OR_RETURN(types.server, libraryId(server));
    for (const CommonTable& table : commonTables()) {
        ASSIGN_OR_RETURN(const auto there, keysOf(server, table));
        ASSIGN_OR_RETURN(const auto here, keysOf(station, table));
        std::vector<Cell> news;
        std::ranges::set_difference(there, here, std::back_inserter(news));
        if (!news.empty())
            types.keys[table.name] = std::move(news);
    }
    if (!types.anyNew())
        return types;
    ASSIGN_OR_RETURN(types.rows, emptyCopy());
    // By these the versions, recipes and people of the server are told.
    const std::array whole{u"library_changes"_s, u"type_versions"_s, u"people"_s};
    for (const QString& table : whole)
        RETURN_IF_ERROR(copyRows(server, *types.rows, table, {}));
    for (const auto& [table, keys] : types.keys)
        if (std::ranges::find(whole, table) == whole.end())
            RETURN_IF_ERROR(copyRows(server, *types.rows, table, keys));
    ASSIGN_OR_RETURN(const qint64 version, change_table::newestVersion(server));
    ASSIGN_OR_RETURN(types.seen, seenVersions(server));
    types.seen[types.server] = version;
    ASSIGN_OR_RETURN(types.state, plantStateAt(server, version));
    return types;
}

Expected<FetchedTypes> takeServerTypes(const ServerTypes& types, Database& station, qint64 delivered)
{
    FetchedTypes fetched;
    ASSIGN_OR_RETURN(const qint64 version, change_table::newestVersion(station));
    fetched.isLate = version != delivered;
    if (fetched.isLate || !types.anyNew())
        return fetched;
    RETURN_IF_ERROR(requireComparableTypes(*types.rows, station));
    const auto leavesOf = [&types](const QString& table) {
        std::vector<NewLeaf> leaves;
        if (const auto keys = types.keys.find(table); keys != types.keys.end())
            for (const Cell& key : keys->second)
                leaves.push_back({types.server, {ledgeredTable(table)->code, key, {}}});
        return leaves;
    };
    RowTaker taker(*types.rows, types.server, station);
    taker.takeWithoutLedger();
    RETURN_IF_ERROR(taker.giveVersions(leavesOf(u"library_changes"_s)));
    for (const TakenTable& table : takenTables())
        if (table.kind != TakenTable::Kind::ForTheRecord) // people: see below
            RETURN_IF_ERROR(taker.take(table, leavesOf(table.name)));
    fetched.rows = taker.taken().sum();
    if (const auto people = types.keys.find(u"people"_s); people != types.keys.end()) {
        ASSIGN_OR_RETURN(const qint64 taken,
                         takeServerPeople(*types.rows, people->second, station, types.place));
        fetched.rows += taken;
    }
    if (fetched.rows == 0) // what is here excludes the rest
        return fetched;
    if (taker.taken().hasChanges) {
        ASSIGN_OR_RETURN(fetched.version, settle(station, types.state, types.place, {}));
    }
    ASSIGN_OR_RETURN(Meeting meeting, meetingOf(types.server, station, fetched.rows, {}));
    meeting.seen = types.seen;
    RETURN_IF_ERROR(meeting_table::insert(station, meeting));
    const QJsonObject details{{u"rows"_s, fetched.rows}, {u"version"_s, fetched.version}};
    RETURN_IF_ERROR(audit_table::append(
        station, {QString::fromUtf16(audit_action::libraryMerged), types.place, {}, details, {}}));
    return fetched;
}

} // namespace gripscope
