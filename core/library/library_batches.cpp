// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/words.h"
#include "core/library/library_private.h"
#include "core/library/tables/audit_table.h"
#include "core/library/tables/inspection_tables.h"
#include "core/people/audit_entry.h"

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

Expected<BatchRecord> withCounts(Database& database, BatchRecord batch)
{
    ASSIGN_OR_RETURN(const auto counts, inspection_table::counts(database, batch.id));
    batch.counts = counts;
    return batch;
}

Expected<std::optional<BatchRecord>> withCounts(Database& database,
                                                Expected<std::optional<BatchRecord>> batch)
{
    if (!batch || !*batch)
        return batch;
    return withCounts(database, std::move(**batch));
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

Expected<void> tellBatch(Database& database, const char16_t* action, const QString& name,
                         const QJsonObject& details, const QString& operatorName)
{
    return audit_table::append(database, {QString::fromUtf16(action), name, {}, details, operatorName});
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
        QJsonObject details{{u"parts"_s, asked.target}};
        if (!asked.expectedType.isEmpty())
            details.insert(u"type"_s, asked.expectedType);
        RETURN_IF_ERROR(
            tellBatch(*d->database, audit_action::batchBegun, asked.name, details, asked.operatorName));
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
        const InspectionCounts& counts = batch->counts;
        QJsonObject details{{u"parts"_s, batch->target}, {u"squeezes"_s, counts.total}};
        if (!batch->expectedType.isEmpty() || counts.asExpected > counts.knownType)
            details.insert(u"as_expected"_s, counts.asExpected - counts.knownType);
        if (counts.knownType > 0)
            details.insert(u"known_type"_s, counts.knownType);
        RETURN_IF_ERROR(
            tellBatch(*d->database, audit_action::batchEnded, batch->name, details, operatorName));
        return requireBatch(*d->database, batchId);
    });
}

Expected<std::optional<BatchRecord>> Library::batchUnderWay() const
{
    return withCounts(*d->database, batch_table::underWay(*d->database, stationId()));
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

Expected<NewInspection> Library::withKnownBatch(NewInspection inspection) const
{
    if (inspection.batchId.isEmpty())
        return inspection;
    ASSIGN_OR_RETURN(const auto known, batch(inspection.batchId));
    if (!known)
        inspection.batchId.clear();
    return inspection;
}

Expected<std::optional<BatchRecord>> Library::batch(const QString& batchId) const
{
    return withCounts(*d->database, batch_table::find(*d->database, batchId));
}

} // namespace gripscope
