// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/store/batch.h"
#include "core/store/statement.h"

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
