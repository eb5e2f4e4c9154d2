// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/store/history.h"
#include "core/store/statement.h"

/// Reads squeezes with all that belongs to them, across the tables; writes nothing.
namespace gripscope::history_view {

[[nodiscard]] Expected<HistoryKeys> keys(Database& database, const HistoryQuery& query);
/// In the order of the keys; those that are not there are left out.
[[nodiscard]] Expected<std::vector<HistoryEntry>> entries(Database& database,
                                                          const std::vector<QString>& graspIds);
[[nodiscard]] Expected<HistoryCounts> counts(Database& database, const HistoryQuery& query);
[[nodiscard]] Expected<HistoryPoints> points(Database& database, HistoryQuery query);
[[nodiscard]] Expected<HistoryChoices> choices(Database& database);

} // namespace gripscope::history_view
