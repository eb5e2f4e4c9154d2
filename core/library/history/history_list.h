// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/library/records/history_list.h"
#include "core/library/sql/database.h"

/// Lists of what a query finds, however many there are; see HistoryList.
namespace gripscope::history_list {

[[nodiscard]] Expected<HistoryList> find(Database& database, const HistoryQuery& query);
/// One stretch further: more of its rows, counts and marks are known then.
[[nodiscard]] Expected<void> goOn(Database& database, HistoryList& list);
/// To the end.
[[nodiscard]] Expected<void> goThrough(Database& database, HistoryList& list);
/// Rows `first` to `first + count - 1`, as many of them as there are.
[[nodiscard]] Expected<std::vector<QString>> keys(Database& database, const HistoryList& list, qint64 first,
                                                  qint64 count);
/// Which row a squeeze is; nothing where it is none of them.
[[nodiscard]] Expected<std::optional<qint64>> rowOf(Database& database, const HistoryList& list,
                                                    const QString& key);

} // namespace gripscope::history_list
