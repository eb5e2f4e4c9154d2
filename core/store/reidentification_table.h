// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/store/history.h"
#include "core/store/statement.h"

namespace gripscope::reidentification_table {

/// Who found the estimate `estimateId` of a stored squeeze later on, and how.
[[nodiscard]] Expected<void> insert(Database& database, const RowStamp& stamp, const QString& graspId,
                                    const QString& estimateId, const Reidentification& how);

} // namespace gripscope::reidentification_table
