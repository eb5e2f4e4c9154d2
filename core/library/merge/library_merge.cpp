// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/merge/library_merge.h"

#include "core/base/words.h"
#include "core/library/merge/known_history.h"
#include "core/library/merge/library_news.h"
#include "core/library/merge/meeting_table.h"
#include "core/library/merge/settlement.h"
#include "core/library/merge/taken_news.h"
#include "core/library/plant/plant_state.h"
#include "core/library/sql/library_location.h"
#include "core/library/sql/rows.h"
#include "core/library/tables/audit_table.h"
#include "core/library/verification/library_verification.h"

#include <QFileInfo>
#include <QJsonArray>

#include <algorithm>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

QString merging()
{
    return Words::tr("merge another library");
}

/// How many rows of the tables that are taken a library has.
Expected<qint64> rowsOf(Database& database)
{
    qint64 rows = 0;
    for (const TakenTable& table : takenTables()) {
        if (table.kind != TakenTable::Kind::Taken)
            continue;
        Statement query(database, merging(), u"SELECT COUNT(*) FROM "_s + table.name);
        ASSIGN_OR_RETURN(const qint64 ofTable, numberOf(query));
        rows += ofTable;
    }
    return rows;
}

QJsonArray toJson(const std::vector<PlantConflict>& conflicts)
{
    constexpr qsizetype mostNamed = 20;
    QJsonArray array;
    for (const PlantConflict& conflict : conflicts)
        if (array.size() < mostNamed)
            array.append(inWords(conflict));
    return array;
}

/// The trail tells of it, and the meeting is on record with the ends of all ledgers that are known then.
Expected<void> tell(Database& source, Database& target, const MergeReport& report, const ChangeNote& note)
{
    ASSIGN_OR_RETURN(const Meeting meeting, meetingWith(source, target, report.rows(), note.operatorName));
    RETURN_IF_ERROR(meeting_table::insert(target, meeting));
    QJsonObject details{{u"rows"_s, report.rows()}, {u"chains"_s, meeting.heads}};
    if (report.version > 0)
        details.insert(u"version"_s, report.version);
    if (!report.conflicts.empty())
        details.insert(u"conflicts"_s, toJson(report.conflicts));
    return audit_table::append(target, {QString::fromUtf16(audit_action::libraryMerged), report.file,
                                        note.reason, details, note.operatorName});
}

Expected<std::vector<PlantConflict>> unseenOf(Database& database, const PlantState& state)
{
    ASSIGN_OR_RETURN(const auto seen, meeting_table::seenConflicts(database));
    std::vector<PlantConflict> conflicts = state.conflicts;
    std::erase_if(conflicts, [&](const PlantConflict& one) { return seen.contains(one.id()); });
    return conflicts;
}

/// What a library takes from a server has no ledger beside it, by which others could follow it.
Expected<void> refuseInStep(Database& database)
{
    ASSIGN_OR_RETURN(const auto server, meeting_table::serverInStep(database));
    if (!server)
        return {};
    return failure(
        ErrorCode::StorageOpen,
        {database.file(), Words::tr("it is kept in step with a server, which has all that is in it: bring "
                                    "the other library to the same server with \"library sync\"")});
}

Expected<void> requireWhole(const QString& file)
{
    ASSIGN_OR_RETURN(const LibraryVerification found, verifyLibrary(file));
    if (found.whole())
        return {};
    return failure(
        ErrorCode::StorageOpen,
        {file, Words::tr("it is not as it was written: %1. Nothing was taken from it. Look at all of "
                         "it with \"library verify\", and merge a backup that is whole")
                   .arg(inWords(found.differences.front()))});
}

} // namespace

qint64 MergeReport::rows() const
{
    qint64 sum = 0;
    for (const auto& [table, rows] : taken)
        sum += rows;
    return sum;
}

QString inWords(const MergeReport& report)
{
    if (report.rows() == 0)
        return Words::tr("Nothing in %1 is new here.").arg(report.file);
    return Words::tr("%1 rows of %2 were taken, %3 were there already.")
        .arg(Words::number(double(report.rows()), 'f', 0), report.file,
             Words::number(double(report.alreadyThere), 'f', 0));
}

Expected<MergeReport> mergeLibrary(Database& source, Database& target, const ChangeNote& note)
{
    ASSIGN_OR_RETURN(const auto oneState, ReadTransaction::begin(source, merging()));
    RETURN_IF_ERROR(refuseInStep(source));
    RETURN_IF_ERROR(refuseInStep(target));
    MergeReport report;
    report.file = source.file();
    ASSIGN_OR_RETURN(const auto news, newsOf(source, target));
    ASSIGN_OR_RETURN(const TakenNews taken, takeNews(source, target, news));
    report.links = taken.links;
    report.taken = taken.rows.byTable;
    report.forTheRecord = taken.rows.forTheRecord;
    ASSIGN_OR_RETURN(const qint64 rows, rowsOf(source));
    report.alreadyThere = std::max(qint64(0), rows - report.rows());
    ReadMeetings read;
    ASSIGN_OR_RETURN(const PlantHistory history, knownHistory(target, read));
    const PlantState state = plantState(history);
    if (taken.rows.hasChanges) {
        ASSIGN_OR_RETURN(report.version, settle(target, state, report.file, note));
    }
    ASSIGN_OR_RETURN(report.conflicts, unseenOf(target, state));
    if (report.rows() == 0) // what was carried along is news to nobody
        return report;
    RETURN_IF_ERROR(tell(source, target, report, note));
    return report;
}

Expected<std::unique_ptr<Database>> openToMerge(const QString& file, const Database& target)
{
    if (target.isOnServer() || LibraryLocation::isOnServer(file))
        return failure(
            ErrorCode::StorageOpen,
            {file,
             Words::tr("libraries are merged file into file; a station is kept in step with a library on a "
                       "server with \"library sync\"")});
    const QString canonical = QFileInfo(file).canonicalFilePath();
    if (!canonical.isEmpty() && canonical == QFileInfo(target.file()).canonicalFilePath())
        return failure(ErrorCode::StorageOpen, {file, Words::tr("it is this library itself")});
    RETURN_IF_ERROR(requireWhole(file));
    return Database::openToRead(file);
}

Expected<std::vector<StationStanding>> stationsOf(Database& database)
{
    std::vector<StationStanding> stations;
    Statement query(
        database, Words::tr("count what is in it"),
        u"SELECT station, COUNT(*), MAX(inspected_utc) FROM inspections GROUP BY station ORDER BY "
        "station"_s);
    const auto done = query.forEach([&](Statement& row) {
        StationStanding one;
        one.station = row.takeText();
        one.inspections = row.takeInteger();
        one.newestUtc = row.takeText();
        one.isHere = one.station == stationId();
        stations.push_back(std::move(one));
    });
    if (!done)
        return tl::unexpected(done.error());
    return stations;
}

Expected<std::vector<PlantConflict>> unseenConflicts(Database& database, ReadMeetings& read)
{
    ASSIGN_OR_RETURN(const bool anyMeeting, meeting_table::isAnyThere(database));
    ASSIGN_OR_RETURN(const auto server, meeting_table::serverInStep(database));
    if (!anyMeeting || server) // a server tells them to its stations
        return std::vector<PlantConflict>();
    ASSIGN_OR_RETURN(const PlantHistory history, knownHistory(database, read));
    return unseenOf(database, plantState(history));
}

Expected<void> noteSeen(Database& database, const std::vector<PlantConflict>& conflicts,
                        const ChangeNote& note)
{
    ASSIGN_OR_RETURN(const auto seen, meeting_table::seenConflicts(database));
    for (const PlantConflict& conflict : conflicts) {
        if (seen.contains(conflict.id()))
            continue;
        RETURN_IF_ERROR(meeting_table::insertSeen(database, conflict.id(), note.operatorName));
        RETURN_IF_ERROR(audit_table::append(database, {QString::fromUtf16(audit_action::conflictsSeen),
                                                       conflict.type,
                                                       inWords(conflict),
                                                       {},
                                                       note.operatorName}));
    }
    return {};
}

} // namespace gripscope
