// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/library/records/process_values.h"
#include "core/library/sql/database.h"

namespace gripscope::process_limits_table {

[[nodiscard]] Expected<void> insert(Database& database, const QString& type, const QString& limits,
                                    const QString& operatorName);
/// The newest of a type by all of its names.
[[nodiscard]] Expected<std::optional<ProcessLimitsRecord>> newest(Database& database,
                                                                  const std::vector<TypeNameSpan>& names);

} // namespace gripscope::process_limits_table
