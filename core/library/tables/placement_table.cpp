// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/tables/placement_table.h"

#include "core/base/words.h"

namespace gripscope::placement_table {

using namespace Qt::StringLiterals;

Expected<void> insert(Database& database, qint64 version, const QString& graspId, const Placement& placement)
{
    const RowStamp stamp = RowStamp::now();
    Statement row(database, Words::tr("place the squeeze"),
                  u"INSERT INTO placements (id, station, created_utc, grasp_id, version, type_id, accepted) "
                  "VALUES (?, ?, ?, ?, ?, ?, ?)"_s);
    row.bind(stamp.id).bind(stamp.station).bind(stamp.utc).bind(graspId).bind(version);
    return row.bind(placement.typeId).bind(placement.accepted ? 1 : 0).run();
}

Expected<std::map<QString, Placement>> at(Database& database, qint64 version)
{
    std::map<QString, Placement> placements;
    Statement query(database, Words::tr("read the squeezes"),
                    u"SELECT g.id, COALESCE(p.type_id, g.type_id), "
                    "CASE WHEN g.library_version > ? THEN 0 ELSE COALESCE(p.accepted, 1) END "
                    "FROM grasps g LEFT JOIN placements p ON p.grasp_id = g.id AND p.version = "
                    "(SELECT MAX(q.version) FROM placements q WHERE q.grasp_id = g.id AND q.version <= ?) "
                    "WHERE g.type_id IS NOT NULL"_s);
    const auto done = query.bind(version).bind(version).forEach([&](Statement& row) {
        const QString graspId = row.takeText();
        const QString typeId = row.takeText();
        placements[graspId] = {typeId, row.takeInteger() != 0};
    });
    if (!done)
        return tl::unexpected(done.error());
    return placements;
}

} // namespace gripscope::placement_table
