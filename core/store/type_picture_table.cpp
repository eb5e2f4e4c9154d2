// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/store/type_picture_table.h"

#include "core/words.h"

namespace gripscope::type_picture_table {

using namespace Qt::StringLiterals;

Expected<void> insert(Database& database, const RowStamp& stamp, const QString& typeId,
                      const QString& pictureId, const QString& operatorName)
{
    Statement row(database, Words::tr("store the type's picture"),
                  u"INSERT INTO type_pictures (id, station, created_utc, type_id, picture_id, operator_name) "
                  "VALUES (?, ?, ?, ?, ?, ?)"_s);
    row.bind(stamp.id).bind(stamp.station).bind(stamp.utc).bind(typeId);
    return row.bindOrNull(pictureId).bind(operatorName).run();
}

Expected<QString> inForce(Database& database, const QString& typeId)
{
    QString pictureId;
    Statement query(database, Words::tr("read the type's picture"),
                    u"SELECT picture_id FROM type_pictures WHERE type_id = ? ORDER BY id DESC LIMIT 1"_s);
    auto done = query.bind(typeId).forEach([&](Statement& row) { pictureId = row.takeText(); });
    if (!done)
        return tl::unexpected(done.error());
    return pictureId;
}

} // namespace gripscope::type_picture_table
