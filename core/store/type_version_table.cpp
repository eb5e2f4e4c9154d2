// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/store/type_version_table.h"

#include "core/store/recipe_columns.h"
#include "core/words.h"

namespace gripscope::type_version_table {

using namespace Qt::StringLiterals;

Expected<void> insert(Database& database, const RowStamp& stamp, const QString& typeId, const Recipe& recipe,
                      const QString& forceUnit, const QString& positionUnit)
{
    Statement row(database, Words::tr("store the recipe"),
                  u"INSERT INTO type_versions (id, station, created_utc, type_id, version, recipe_name, "
                  u"peak_n, bias_n, "
                  "bit_s, seconds, max_force_n, max_travel_m, force_unit, position_unit) VALUES (?, ?, ?, ?, "
                  "(SELECT COALESCE(MAX(version), 0) + 1 FROM type_versions WHERE type_id = ?), "
                  "?, ?, ?, ?, ?, ?, ?, ?, ?)"_s);
    row.bind(stamp.id).bind(stamp.station).bind(stamp.utc).bind(typeId).bind(typeId);
    bindRecipe(row, recipe);
    return row.bind(forceUnit).bind(positionUnit).run();
}

Expected<int> newest(Database& database, const QString& typeId)
{
    int version = 0;
    Statement query(database, Words::tr("read the recipe"),
                    u"SELECT COALESCE(MAX(version), 0) FROM type_versions WHERE type_id = ?"_s);
    const auto done = query.bind(typeId).forEach([&](Statement& row) { version = int(row.takeInteger()); });
    if (!done)
        return tl::unexpected(done.error());
    return version;
}

} // namespace gripscope::type_version_table
