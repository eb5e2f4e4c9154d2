// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/store/statement.h"

namespace gripscope::approval_table {

[[nodiscard]] Expected<void> insert(Database& database, const RowStamp& stamp, const QString& typeId,
                                    const QString& operatorName);

} // namespace gripscope::approval_table
