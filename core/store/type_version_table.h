// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/store/library.h"
#include "core/store/statement.h"

namespace gripscope::type_version_table {

/// Appends the next version of a type.
[[nodiscard]] Expected<void> insert(Database& database, const RowStamp& stamp, const QString& typeId,
                                    const Recipe& recipe, const QString& forceUnit,
                                    const QString& positionUnit);
[[nodiscard]] Expected<int> newest(Database& database, const QString& typeId); ///< 0: none

} // namespace gripscope::type_version_table
