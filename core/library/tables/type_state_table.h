// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/library/records/library_change.h"
#include "core/library/sql/statement.h"

#include <vector>

namespace gripscope::type_state_table {

/// From `version` of the library on the type is as `state` says.
[[nodiscard]] Expected<void> insert(Database& database, qint64 version, const TypeState& state);
/// Every type that there was at `version`, those that are gone too, by key; squeezes not counted.
[[nodiscard]] Expected<std::vector<TypeState>> at(Database& database, qint64 version);

} // namespace gripscope::type_state_table
