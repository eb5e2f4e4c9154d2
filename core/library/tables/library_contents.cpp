// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/tables/library_contents.h"

#include "core/base/words.h"
#include "core/library/sql/statement.h"

namespace gripscope {

using namespace Qt::StringLiterals;

Expected<LibraryContents> contentsOf(Database& database)
{
    LibraryContents contents;
    // Numbers of inspections, entries and versions have no holes.
    Statement query(database, Words::tr("count what is in it"),
                    u"SELECT (SELECT COUNT(*) FROM types), (SELECT COUNT(*) FROM grasps), "
                    "(SELECT COALESCE(MAX(number), 0) FROM inspections), "
                    "(SELECT COUNT(*) FROM calibrations), "
                    "(SELECT COALESCE(MAX(number), 0) FROM audit_entries), "
                    "(SELECT COALESCE(MAX(version), 0) FROM library_changes), "
                    "(SELECT COALESCE(MAX(created_utc), '') FROM ledger)"_s);
    const auto done = query.forEach([&](Statement& row) {
        for (qint64* count : {&contents.types, &contents.squeezes, &contents.inspections,
                              &contents.calibrations, &contents.entries, &contents.version})
            *count = row.takeInteger();
        contents.newest = row.takeUtc();
    });
    if (!done)
        return tl::unexpected(done.error());
    return contents;
}

} // namespace gripscope
