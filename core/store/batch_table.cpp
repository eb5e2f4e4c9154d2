// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/store/batch_table.h"

#include "core/store/rows.h"
#include "core/words.h"

#include <algorithm>

namespace gripscope::batch_table {

using namespace Qt::StringLiterals;

namespace {

QString reading()
{
    return Words::tr("read the batches");
}

const auto select = u"SELECT b.id, b.begun_utc, b.name, b.target, b.expected_type, b.operator_name, "
                    u"COALESCE(e.ended_utc, '') "
                    "FROM batches b LEFT JOIN batch_ends e ON e.batch_id = b.id "_s;

BatchRecord takeBatch(Statement& row)
{
    BatchRecord batch;
    batch.id = row.takeText();
    batch.begun = row.takeUtc();
    batch.name = row.takeText();
    batch.target = row.takeInteger();
    batch.expectedType = row.takeText();
    batch.operatorName = row.takeText();
    if (const QDateTime ended = row.takeUtc(); ended.isValid())
        batch.ended = ended;
    return batch;
}

} // namespace

Expected<void> insert(Database& database, const RowStamp& stamp, const NewBatch& batch)
{
    Statement row(database, Words::tr("begin the batch"),
                  u"INSERT INTO batches (id, station, begun_utc, name, target, expected_type, operator_name) "
                  "VALUES (?, ?, ?, ?, ?, ?, ?)"_s);
    row.bind(stamp.id).bind(stamp.station).bind(stamp.utc).bind(batch.name).bind(batch.target);
    return row.bind(batch.expectedType).bind(batch.operatorName).run();
}

Expected<void> insertEnd(Database& database, const QString& batchId, const QString& operatorName)
{
    const RowStamp stamp = RowStamp::now();
    Statement row(database, Words::tr("end the batch"),
                  u"INSERT INTO batch_ends (id, station, ended_utc, batch_id, operator_name) "
                  "VALUES (?, ?, ?, ?, ?)"_s);
    row.bind(stamp.id).bind(stamp.station).bind(stamp.utc).bind(batchId);
    return row.bind(operatorName).run();
}

Expected<std::optional<BatchRecord>> find(Database& database, const QString& id)
{
    Statement query(database, reading(), select + u"WHERE b.id = ?"_s);
    return firstRow(query.bind(id), takeBatch);
}

Expected<std::optional<BatchRecord>> underWay(Database& database, const QString& station)
{
    Statement query(database, reading(),
                    select + u"WHERE b.station = ? AND e.id IS NULL ORDER BY b.begun_utc DESC, b.id DESC "
                             "LIMIT 1"_s);
    return firstRow(query.bind(station), takeBatch);
}

Expected<std::vector<BatchRecord>> newest(Database& database, int limit)
{
    Statement query(database, reading(), select + u"ORDER BY b.begun_utc DESC, b.id DESC LIMIT ?"_s);
    return allRows(query.bind(std::max(0, limit)), takeBatch);
}

} // namespace gripscope::batch_table
