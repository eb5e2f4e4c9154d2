// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/library/records/batch.h"
#include "core/library/records/inspection_record.h"
#include "core/library/sql/statement.h"

namespace gripscope::inspection_table {

/// What the measurement of inspection `i` is worth, as toString(ValidityVerdict); empty: not recorded. Rows
/// from before it had a column have it in their document.
[[nodiscard]] QString validitySql();
/// "type does_not_conform", as partJudgedFromString() reads it, of the row `table` ("i.", or "").
[[nodiscard]] QString judgedSql(const QString& table = {});
/// The number that an inspection has in the library of another station, where it was made; 0: it was made
/// here. `id`: SQL for its key.
[[nodiscard]] QString numberThereSql(const QString& id);
/// The sentences of a stored list, as one text.
/// As they were stored, sentences of earlier versions as text; what is no reason is left out.
[[nodiscard]] Finding joinReasons(const QString& json);
/// Numbers the inspection: one more than the highest so far. Inside a write transaction, so that two never
/// meet.
[[nodiscard]] Expected<void> insert(Database& database, const RowStamp& stamp, const QString& graspId,
                                    const NewInspection& inspection);
[[nodiscard]] Expected<std::optional<InspectionRecord>> find(Database& database, const QString& id);
[[nodiscard]] Expected<std::optional<InspectionRecord>> withNumber(Database& database, qint64 number);
[[nodiscard]] Expected<std::vector<InspectionRecord>> page(Database& database, const HistoryFilter& filter);
/// Of one batch, or of all where it is empty; those with a number behind `after` only.
[[nodiscard]] Expected<InspectionCounts> counts(Database& database, const QString& batchId = {},
                                                qint64 after = 0);

} // namespace gripscope::inspection_table

namespace gripscope::void_table {

/// `inspectionId` does not count from now on; it must not be there yet.
[[nodiscard]] Expected<void> insert(Database& database, const QString& inspectionId, const QString& reason,
                                    const QString& operatorName);
} // namespace gripscope::void_table

namespace gripscope::batch_table {

[[nodiscard]] Expected<void> insert(Database& database, const RowStamp& stamp, const NewBatch& batch);
[[nodiscard]] Expected<void> insertEnd(Database& database, const QString& batchId,
                                       const QString& operatorName);
// What is read comes without its counts.
[[nodiscard]] Expected<std::optional<BatchRecord>> find(Database& database, const QString& id);
/// The newest of `station` that has no end.
[[nodiscard]] Expected<std::optional<BatchRecord>> underWay(Database& database, const QString& station);
[[nodiscard]] Expected<std::vector<BatchRecord>> newest(Database& database, int limit);

} // namespace gripscope::batch_table
