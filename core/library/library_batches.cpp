// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/words.h"
#include "core/library/library_private.h"
#include "core/library/tables/inspection_tables.h"

namespace gripscope {

namespace {

Expected<BatchRecord> withCounts(Database& database, BatchRecord batch)
{
    ASSIGN_OR_RETURN(const auto counts, inspection_table::counts(database, batch.id));
    batch.counts = counts;
    return batch;
}

Expected<BatchRecord> requireBatch(Database& database, const QString& id)
{
    ASSIGN_OR_RETURN(const auto batch, batch_table::find(database, id));
    if (!batch)
        return failure(ErrorCode::NotFound, {Words::tr("batch with the key %1").arg(id)});
    return withCounts(database, *batch);
}

Expected<void> check(const NewBatch& batch)
{
    if (batch.name.isEmpty() || batch.name.size() > longestBatchName)
        return failure(
            ErrorCode::Usage,
            {Words::tr("A batch needs a name or number of at most %1 characters.").arg(longestBatchName)});
    if (batch.target < 1 || batch.target > largestBatch)
        return failure(ErrorCode::Usage, {Words::tr("A batch has 1 to %1 parts.").arg(largestBatch)});
    return {};
}

} // namespace

Expected<BatchRecord> Library::beginBatch(const NewBatch& batch)
{
    NewBatch asked = batch;
    asked.name = batch.name.trimmed();
    RETURN_IF_ERROR(check(asked));
    return d->write<BatchRecord>(Words::tr("begin the batch"), [&]() -> Expected<BatchRecord> {
        const RowStamp stamp = RowStamp::now();
        ASSIGN_OR_RETURN(const auto other, batch_table::underWay(*d->database, stamp.station));
        if (other)
            return failure(ErrorCode::Usage,
                           {Words::tr("Batch %1 is under way here. End it first.").arg(other->name)});
        RETURN_IF_ERROR(batch_table::insert(*d->database, stamp, asked));
        return requireBatch(*d->database, stamp.id);
    });
}

Expected<BatchRecord> Library::endBatch(const QString& batchId, const QString& operatorName)
{
    return d->write<BatchRecord>(Words::tr("end the batch"), [&]() -> Expected<BatchRecord> {
        const auto batch = requireBatch(*d->database, batchId);
        if (!batch || batch->ended)
            return batch;
        RETURN_IF_ERROR(batch_table::insertEnd(*d->database, batchId, operatorName));
        return requireBatch(*d->database, batchId);
    });
}

Expected<std::optional<BatchRecord>> Library::batchUnderWay() const
{
    const auto batch = batch_table::underWay(*d->database, stationId());
    if (!batch || !*batch)
        return batch;
    return withCounts(*d->database, **batch).map([](const BatchRecord& counted) {
        return std::optional<BatchRecord>(counted);
    });
}

Expected<std::vector<BatchRecord>> Library::batches(int limit) const
{
    auto batches = batch_table::newest(*d->database, limit);
    if (!batches)
        return batches;
    for (BatchRecord& batch : *batches) {
        ASSIGN_OR_RETURN(auto counted, withCounts(*d->database, batch));
        batch = std::move(counted);
    }
    return batches;
}

} // namespace gripscope
