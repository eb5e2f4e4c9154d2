// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/store/picture_table.h"

#include "core/store/digest.h"
#include "core/words.h"

namespace gripscope::picture_table {

using namespace Qt::StringLiterals;

Expected<void> insert(Database& database, const RowStamp& stamp, const PartPicture& picture)
{
    Statement row(database, Words::tr("store the picture"),
                  u"INSERT INTO pictures (id, station, created_utc, format, width, height, sha256, bytes) "
                  "VALUES (?, ?, ?, ?, ?, ?, ?, ?)"_s);
    row.bind(picture.id).bind(stamp.station).bind(stamp.utc).bind(picture.format);
    row.bind(picture.width).bind(picture.height).bind(sha256(picture.bytes)).bindBytes(picture.bytes);
    return row.run();
}

Expected<PartPicture> read(Database& database, const QString& id)
{
    PartPicture picture;
    QString digest;
    Statement query(database, Words::tr("read the picture"),
                    u"SELECT id, format, width, height, sha256, bytes FROM pictures WHERE id = ?"_s);
    auto done = query.bind(id).forEach([&](Statement& row) {
        picture.id = row.takeText();
        picture.format = row.takeText();
        picture.width = int(row.takeInteger());
        picture.height = int(row.takeInteger());
        digest = row.takeText();
        picture.bytes = row.takeBytes();
    });
    if (!done)
        return tl::unexpected(done.error());
    if (picture.id.isEmpty())
        return failure(ErrorCode::NotFound, {Words::tr("picture %1").arg(id)});
    if (sha256(picture.bytes) != digest)
        return failure(ErrorCode::StorageCorrupt, {Words::tr("The picture %1").arg(id),
                                                   Words::tr("its bytes are not those that were stored")});
    return picture;
}

} // namespace gripscope::picture_table
