// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/store/library.h"
#include "core/store/statement.h"

namespace gripscope::type_table {

[[nodiscard]] Expected<void> insert(Database& database, const RowStamp& stamp, const QString& name);
/// Every type that is not gone, retired ones too, as it is now, by name.
[[nodiscard]] Expected<std::vector<TypeRecord>> all(Database& database);
[[nodiscard]] Expected<std::optional<TypeRecord>> findByName(Database& database, const QString& name);
[[nodiscard]] Expected<std::optional<TypeRecord>> findById(Database& database, const QString& id);

} // namespace gripscope::type_table
