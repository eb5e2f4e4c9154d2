// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/merge/meeting_table.h"

#include "core/base/words.h"
#include "core/library/ledger/merged_ledger.h"
#include "core/library/merge/known_history.h"
#include "core/library/sql/rows.h"
#include "core/library/tables/change_table.h"

#include <QJsonDocument>

#include <algorithm>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

QString text(const QJsonObject& object)
{
    return QString::fromUtf8(QJsonDocument(object).toJson(QJsonDocument::Compact));
}

/// What no meeting of the library knows yet.
Expected<QJsonObject> newlySeen(Database& database, const Meeting& meeting)
{
    std::map<QString, qint64> known;
    if (!meeting.seen.empty()) {
        Statement query(database, Words::tr("read its merges"),
                        u"SELECT seen FROM library_meetings WHERE seen <> '{}' AND library = ?"_s);
        RETURN_IF_ERROR(query.bind(meeting.library).forEach([&](Statement& row) {
            for (const auto& [library, version] : seenFromText(row.takeText()))
                known[library] = std::max(known[library], version);
        }));
    }
    QJsonObject news;
    for (const auto& [library, version] : meeting.seen)
        if (const auto before = known.find(library); before == known.end() || before->second < version)
            news.insert(library, version);
    return news;
}

} // namespace

std::map<QString, qint64> seenFromText(const QString& json)
{
    std::map<QString, qint64> versions;
    const QJsonObject object = QJsonDocument::fromJson(json.toUtf8()).object();
    for (auto one = object.begin(); one != object.end(); ++one)
        versions[one.key()] = one.value().toInteger();
    return versions;
}

Expected<Meeting> meetingOf(const QString& other, Database& target, qint64 taken, const QString& operatorName)
{
    Meeting meeting;
    ASSIGN_OR_RETURN(meeting.library, libraryId(target));
    meeting.other = other;
    ASSIGN_OR_RETURN(meeting.version, change_table::newestVersion(target));
    meeting.taken = taken;
    meeting.operatorName = operatorName;
    return meeting;
}

Expected<Meeting> meetingWith(Database& source, Database& target, qint64 taken, const QString& operatorName)
{
    ASSIGN_OR_RETURN(const QString other, libraryId(source));
    ASSIGN_OR_RETURN(Meeting meeting, meetingOf(other, target, taken, operatorName));
    ASSIGN_OR_RETURN(meeting.seen, seenVersions(target));
    ASSIGN_OR_RETURN(const auto ends, merged_ledger::ends(target));
    for (const auto& [chain, end] : ends)
        meeting.addHead(chain.first, end);
    return meeting;
}

void Meeting::addHead(const QString& ofLibrary, const ChainEnd& end)
{
    heads.insert(ofLibrary + u' ' + end.chain,
                 u"%1 %2"_s.arg(end.links).arg(QString::fromLatin1(end.hash.toHex())));
}

namespace meeting_table {

Expected<void> insert(Database& database, const Meeting& meeting)
{
    ASSIGN_OR_RETURN(const QJsonObject seen, newlySeen(database, meeting));
    const RowStamp stamp = RowStamp::now();
    Statement row(database, Words::tr("record the merge"),
                  u"INSERT INTO library_meetings (id, station, created_utc, library, version, other, seen, "
                  "heads, taken, operator_name) VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?)"_s);
    row.bind(stamp.id).bind(stamp.station).bind(stamp.utc).bind(meeting.library).bind(meeting.version);
    row.bind(meeting.other).bind(text(seen)).bind(text(meeting.heads)).bind(meeting.taken);
    return row.bind(meeting.operatorName).run();
}

Expected<bool> isAnyThere(Database& database)
{
    Statement query(database, Words::tr("read its merges"), u"SELECT 1 FROM library_meetings LIMIT 1"_s);
    return numberOf(query).map([](qint64 found) { return found != 0; });
}

Expected<std::optional<QString>> serverInStep(Database& database)
{
    Statement query(database, Words::tr("read its merges"),
                    u"SELECT other FROM library_meetings WHERE heads = '{}' ORDER BY id DESC LIMIT 1"_s);
    return firstRow(
        query, +[](Statement& row) { return row.takeText(); });
}

Expected<void> insertSeen(Database& database, const QString& conflict, const QString& operatorName)
{
    const RowStamp stamp = RowStamp::now();
    Statement row(
        database, Words::tr("note that it was seen"),
        u"INSERT INTO conflicts_seen (id, station, created_utc, conflict, operator_name) VALUES (?, "
        "?, ?, ?, ?)"_s);
    row.bind(stamp.id).bind(stamp.station).bind(stamp.utc);
    return row.bind(conflict).bind(operatorName).run();
}

Expected<QSet<QString>> seenConflicts(Database& database)
{
    QSet<QString> seen;
    Statement query(database, Words::tr("read its merges"), u"SELECT conflict FROM conflicts_seen"_s);
    if (auto done = query.forEach([&](Statement& row) { seen.insert(row.takeText()); }); !done)
        return tl::unexpected(done.error());
    return seen;
}

} // namespace meeting_table
} // namespace gripscope
