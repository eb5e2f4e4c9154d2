// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/estimate.h"
#include "core/store/statement.h"

namespace gripscope::estimate_table {

/// `rank` 0: the recommended one.
[[nodiscard]] Expected<void> insert(Database& database, const RowStamp& stamp, const QString& graspId,
                                    int rank, const Estimate& estimate);

} // namespace gripscope::estimate_table
