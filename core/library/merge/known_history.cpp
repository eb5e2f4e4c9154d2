// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/merge/known_history.h"

#include "core/base/words.h"
#include "core/library/ledger/ledgered_tables.h"
#include "core/library/ledger/merged_ledger.h"
#include "core/library/ledger/merged_rows.h"
#include "core/library/merge/meeting_table.h"
#include "core/library/sql/statement.h"

#include <algorithm>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

QString readingHistory()
{
    return Words::tr("read the changes of all stations");
}

/// A version here: where it was made, as what.
struct KnownChange {
    QString library;
    qint64 version = 0;
    ChangeKind kind = ChangeKind::NewType;
    QString person;
};

using KnownChanges = std::map<qint64, KnownChange>; ///< by the version here

Expected<KnownChanges> changesOf(Database& database, const QString& own)
{
    KnownChanges changes;
    Statement query(
        database, readingHistory(),
        u"SELECT c.version, c.kind, c.operator_name, COALESCE(m.library, ''), COALESCE(m.number, 0) "
        "FROM library_changes c LEFT JOIN merged_rows m ON m.table_code = ? AND m.row_key = c.id "
        "AND m.is_origin = 1"_s);
    query.bind(int(ledgeredTable(u"library_changes"_s)->code));
    const auto done = query.forEach([&](Statement& row) {
        const qint64 here = row.takeInteger();
        KnownChange change;
        change.kind = changeKindFromString(row.takeText()).value_or(ChangeKind::Restore);
        change.person = row.takeText();
        change.library = row.takeText();
        change.version = row.takeInteger();
        if (change.library.isEmpty()) {
            change.library = own;
            change.version = here;
        }
        changes[here] = change;
    });
    if (!done)
        return tl::unexpected(done.error());
    return changes;
}

/// Takes the stamp of a row: key, station, time, version.
ChangeStamp takeStamp(Statement& row, const KnownChanges& changes, ChangeKind& kind)
{
    ChangeStamp stamp;
    stamp.row = row.takeText();
    stamp.station = row.takeText();
    stamp.utc = row.takeText();
    const auto change = changes.find(row.takeInteger());
    if (change == changes.end()) // from before there were versions
        return stamp;
    stamp.library = change->second.library;
    stamp.version = change->second.version;
    stamp.person = change->second.person;
    kind = change->second.kind;
    return stamp;
}

Expected<void> readTypes(Database& database, const KnownChanges& changes, PlantHistory& history)
{
    Statement query(
        database, readingHistory(),
        u"SELECT s.id, s.station, s.created_utc, s.version, s.type_id, s.name, s.status, "
        "COALESCE(v.id, ''), s.code, s.part_limits FROM type_states s LEFT JOIN type_versions v ON "
        "v.type_id = s.type_id AND v.version = s.recipe_version"_s);
    return query.forEach([&](Statement& row) {
        TypeChange change;
        change.stamp = takeStamp(row, changes, change.kind);
        change.typeId = row.takeText();
        change.name = row.takeText();
        change.status = typeStatusFromString(row.takeText()).value_or(TypeStatus::Gone);
        change.recipe = row.takeText();
        change.code = row.takeText();
        change.limits = row.takeText();
        if (change.kind != ChangeKind::Meeting)
            history.types.push_back(std::move(change));
    });
}

Expected<void> readSqueezes(Database& database, const KnownChanges& changes, const QString& sql,
                            PlantHistory& history)
{
    Statement query(database, readingHistory(), sql);
    return query.forEach([&](Statement& row) {
        SqueezeChange change;
        change.stamp = takeStamp(row, changes, change.kind);
        change.squeeze = row.takeText();
        change.typeId = row.takeText();
        change.accepted = row.takeInteger() != 0;
        if (change.kind != ChangeKind::Meeting)
            history.squeezes.push_back(std::move(change));
    });
}

/// None at first: SQLite would go through the whole table by the number instead of by an index.
QString behind(qint64 row)
{
    return row > 0 ? u" AND rowid > %1"_s.arg(row) : QString();
}

Expected<void> readMeetings(Database& database, ReadMeetings& read)
{
    // Most brought no change: these are not looked at, and are millions.
    Statement query(database, readingHistory(),
                    u"SELECT rowid, library, version, seen FROM library_meetings WHERE seen <> '{}'"_s +
                        behind(read.own));
    RETURN_IF_ERROR(query.forEach([&](Statement& row) {
        read.own = std::max(read.own, row.takeInteger());
        PlantMeeting meeting;
        meeting.library = row.takeText();
        meeting.version = row.takeInteger();
        meeting.seen = seenFromText(row.takeText());
        read.meetings.push_back(std::move(meeting));
    }));
    ASSIGN_OR_RETURN(const auto columns, columnsOf(database, u"library_meetings"_s));
    Statement others(database, readingHistory(), // the number as it stands in its index
                     u"SELECT rowid, content FROM merged_rows WHERE table_code = %1"_s.arg(
                         ledgeredTable(u"library_meetings"_s)->code) +
                         behind(read.ofOthers));
    return others.forEach([&](Statement& row) {
        read.ofOthers = std::max(read.ofOthers, row.takeInteger());
        TableRows::Row cells(columns->size());
        if (!merged_rows::apply(row.takeText(), *columns, cells))
            return;
        read.meetings.push_back({textIn(*columns, cells, u"library"), integerIn(*columns, cells, u"version"),
                                 seenFromText(textIn(*columns, cells, u"seen"))});
    });
}

} // namespace

Expected<PlantHistory> knownHistory(Database& database, ReadMeetings& read)
{
    ASSIGN_OR_RETURN(const QString own, libraryId(database));
    ASSIGN_OR_RETURN(const KnownChanges changes, changesOf(database, own));
    PlantHistory history;
    RETURN_IF_ERROR(readTypes(database, changes, history));
    RETURN_IF_ERROR(readSqueezes(database, changes,
                                 u"SELECT id, station, recorded_utc, library_version, id, type_id, 1 FROM "
                                 "grasps WHERE type_id IS NOT NULL"_s,
                                 history));
    RETURN_IF_ERROR(
        readSqueezes(database, changes,
                     u"SELECT id, station, created_utc, version, grasp_id, type_id, accepted FROM "
                     "placements"_s,
                     history));
    RETURN_IF_ERROR(readMeetings(database, read));
    history.meetings = read.meetings;
    return history;
}

Expected<std::map<QString, qint64>> seenVersions(Database& database)
{
    std::map<QString, qint64> seen;
    Statement query(
        database, readingHistory(),
        u"SELECT library, MAX(number) FROM merged_rows WHERE table_code = ? AND is_origin = 1 GROUP "
        "BY library"_s);
    query.bind(int(ledgeredTable(u"library_changes"_s)->code));
    const auto done = query.forEach([&](Statement& row) {
        const QString library = row.takeText();
        seen[library] = row.takeInteger();
    });
    if (!done)
        return tl::unexpected(done.error());
    return seen;
}

} // namespace gripscope
