// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/store/enrollment_draft.h"
#include "core/store/statement.h"

namespace gripscope::draft_squeeze_table {

[[nodiscard]] Expected<void> insert(Database& database, const RowStamp& stamp, const DraftSqueeze& squeeze);
/// NotFound; StorageCorrupt when the bytes are not those that were stored.
[[nodiscard]] Expected<DraftSqueeze> read(Database& database, const QString& id);

} // namespace gripscope::draft_squeeze_table
