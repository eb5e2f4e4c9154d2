// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/store/statement.h"

namespace gripscope::decision_table {

[[nodiscard]] Expected<void> insertDrop(Database& database, const RowStamp& stamp, const QString& graspId,
                                        const QString& reason, const QString& operatorName);

} // namespace gripscope::decision_table
