// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/store/enrollment_draft.h"
#include "core/store/statement.h"

namespace gripscope::picture_table {

[[nodiscard]] Expected<void> insert(Database& database, const RowStamp& stamp, const PartPicture& picture);
/// NotFound; StorageCorrupt when the bytes are not those that were stored.
[[nodiscard]] Expected<PartPicture> read(Database& database, const QString& id);

} // namespace gripscope::picture_table
