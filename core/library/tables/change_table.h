// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/library/records/library_change.h"
#include "core/library/sql/statement.h"

#include <vector>

namespace gripscope::change_table {

/// Records a change and numbers it: one more than the highest version so far. Inside a write transaction, so
/// that two never meet. `version`, `changed` and `station` of `change` are not read.
[[nodiscard]] Expected<qint64> insert(Database& database, const LibraryChange& change);
/// The same without an entry in the audit trail, which tells of it otherwise.
[[nodiscard]] Expected<qint64> insertUntold(Database& database, const LibraryChange& change);
[[nodiscard]] Expected<qint64> newestVersion(Database& database); ///< 0: none yet
/// Newest first.
[[nodiscard]] Expected<std::vector<LibraryChange>> page(Database& database, int limit, int offset);

} // namespace gripscope::change_table
