// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/tables/document_table.h"

#include "core/base/words.h"

#include <QJsonDocument>

namespace gripscope::document_table {

using namespace Qt::StringLiterals;

Expected<void> insert(Database& database, const RowStamp& stamp, const QString& graspId,
                      const QJsonObject& document)
{
    Statement row(
        database, Words::tr("store the squeeze"),
        u"INSERT INTO documents (id, station, created_utc, grasp_id, document) VALUES (?, ?, ?, ?, ?)"_s);
    row.bind(stamp.id).bind(stamp.station).bind(stamp.utc).bind(graspId);
    return row.bind(QString::fromUtf8(QJsonDocument(document).toJson(QJsonDocument::Compact))).run();
}

Expected<QJsonObject> read(Database& database, const QString& graspId)
{
    QJsonObject document;
    Statement query(database, Words::tr("read the squeeze"),
                    u"SELECT document FROM documents WHERE grasp_id = ?"_s);
    auto done = query.bind(graspId).forEach(
        [&](Statement& row) { document = QJsonDocument::fromJson(row.takeText().toUtf8()).object(); });
    if (!done)
        return tl::unexpected(done.error());
    return document;
}

} // namespace gripscope::document_table
