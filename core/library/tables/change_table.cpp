// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/tables/change_table.h"

#include "core/base/words.h"
#include "core/library/sql/rows.h"
#include "core/library/tables/audit_table.h"

#include <algorithm>

namespace gripscope::change_table {

using namespace Qt::StringLiterals;

namespace {

QString readingVersions()
{
    return Words::tr("read its versions");
}

/// Every version is an entry of the audit trail, too, but for those by which an earlier library was brought
/// up to date (migration 14): the ledger tells of these, and nobody did them.
Expected<void> audit(Database& database, const LibraryChange& change, qint64 version)
{
    NewAuditEntry entry;
    entry.action = QString::fromUtf16(audit_action::typePrefix) + toString(change.kind);
    entry.subject = change.type;
    entry.reason = change.reason;
    entry.operatorName = change.operatorName;
    entry.details = {{u"version"_s, version}};
    if (change.other == QString::fromUtf16(approvalVoid))
        entry.details.insert(u"approval_void"_s, true);
    else if (!change.other.isEmpty())
        entry.details.insert(u"other"_s, change.other);
    if (change.squeezes != 0)
        entry.details.insert(u"squeezes"_s, change.squeezes);
    return audit_table::append(database, entry);
}

} // namespace

Expected<qint64> insert(Database& database, const LibraryChange& change)
{
    ASSIGN_OR_RETURN(const qint64 version, insertUntold(database, change));
    RETURN_IF_ERROR(audit(database, change, version));
    return version;
}

Expected<qint64> insertUntold(Database& database, const LibraryChange& change)
{
    const auto newest = newestVersion(database);
    if (!newest)
        return newest;
    const RowStamp stamp = RowStamp::now();
    Statement row(database, Words::tr("record the change"),
                  u"INSERT INTO library_changes (id, station, changed_utc, version, kind, type_name, "
                  "other_name, squeezes, operator_name, reason) VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?)"_s);
    row.bind(stamp.id).bind(stamp.station).bind(stamp.utc).bind(*newest + 1).bind(toString(change.kind));
    row.bind(change.type).bind(change.other).bind(change.squeezes);
    RETURN_IF_ERROR(row.bind(change.operatorName).bind(change.reason).run());
    return *newest + 1;
}

Expected<qint64> newestVersion(Database& database)
{
    Statement query(database, readingVersions(), u"SELECT COALESCE(MAX(version), 0) FROM library_changes"_s);
    return numberOf(query);
}

Expected<std::vector<LibraryChange>> page(Database& database, int limit, int offset)
{
    std::vector<LibraryChange> changes;
    Statement query(database, readingVersions(),
                    u"SELECT version, changed_utc, station, kind, type_name, other_name, squeezes, "
                    "operator_name, reason FROM library_changes ORDER BY version DESC LIMIT ? OFFSET ?"_s);
    query.bind(std::max(0, limit)).bind(std::max(0, offset));
    const auto done = query.forEach([&](Statement& row) {
        LibraryChange change;
        change.version = row.takeInteger();
        change.changed = row.takeUtc();
        change.station = row.takeText();
        change.kind = changeKindFromString(row.takeText()).value_or(ChangeKind::NewType);
        change.type = row.takeText();
        change.other = row.takeText();
        change.squeezes = int(row.takeInteger());
        change.operatorName = row.takeText();
        change.reason = row.takeText();
        changes.push_back(std::move(change));
    });
    if (!done)
        return tl::unexpected(done.error());
    return changes;
}

} // namespace gripscope::change_table
