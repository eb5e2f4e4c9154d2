// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/store/library.h"
#include "core/store/statement.h"

namespace gripscope::inspection_table {

/// The sentences of a stored list, as one text.
[[nodiscard]] QString joinReasons(const QString& json);
/// Numbers the inspection: one more than the highest so far. Inside a write transaction, so that two never
/// meet.
[[nodiscard]] Expected<void> insert(Database& database, const RowStamp& stamp, const QString& graspId,
                                    const NewInspection& inspection);
[[nodiscard]] Expected<std::optional<InspectionRecord>> find(Database& database, const QString& id);
[[nodiscard]] Expected<std::vector<InspectionRecord>> page(Database& database, const HistoryFilter& filter);
/// Of one batch; of all where it is empty.
[[nodiscard]] Expected<InspectionCounts> counts(Database& database, const QString& batchId = {});

} // namespace gripscope::inspection_table
