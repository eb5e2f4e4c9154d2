// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/tables/document_table.h"

#include "core/base/words.h"
#include "core/library/packing/inflate.h"

#include <QJsonDocument>

namespace gripscope::document_table {

using namespace Qt::StringLiterals;

namespace {

constexpr qint64 mostBytesOfDocument = 64'000'000; ///< a thousand times the largest there are

} // namespace

Expected<void> insert(Database& database, const RowStamp& stamp, const QString& graspId,
                      const QJsonObject& document)
{
    Statement row(
        database, Words::tr("store the squeeze"),
        u"INSERT INTO documents (id, station, created_utc, grasp_id, document, packed) VALUES (?, ?, ?, ?, '', ?)"_s);
    row.bind(stamp.id).bind(stamp.station).bind(stamp.utc).bind(graspId);
    return row.bindBytes(qCompress(QJsonDocument(document).toJson(QJsonDocument::Compact), 9)).run();
}

Expected<QJsonObject> read(Database& database, const QString& graspId)
{
    QJsonObject document;
    Statement query(database, Words::tr("read the squeeze"),
                    u"SELECT document, packed FROM documents WHERE grasp_id = ?"_s);
    bool damaged = false;
    auto done = query.bind(graspId).forEach([&](Statement& row) {
        const QByteArray text = row.takeText().toUtf8();
        const QByteArray packed = row.takeBytes();
        const QJsonDocument read =
            QJsonDocument::fromJson(packed.isNull() ? text : inflated(packed, mostBytesOfDocument));
        document = read.object();
        damaged = !read.isObject();
    });
    if (!done)
        return tl::unexpected(done.error());
    if (damaged)
        return failure(ErrorCode::StorageCorrupt, {Words::tr("The document of the squeeze %1").arg(graspId),
                                                   Words::tr("its bytes are not those that were stored")});
    return document;
}

} // namespace gripscope::document_table
