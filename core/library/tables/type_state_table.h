// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/library/records/library_change.h"
#include "core/library/records/process_values.h"
#include "core/library/sql/statement.h"

#include <vector>

namespace gripscope::type_state_table {

/// From `version` of the library on the type is as `state` says.
[[nodiscard]] Expected<void> insert(Database& database, qint64 version, const TypeState& state);
/// Every type that there was at `version`, those that are gone too, by key; squeezes not counted.
[[nodiscard]] Expected<std::vector<TypeState>> at(Database& database, qint64 version);

/// The names of the type that has this name, or had it last; the name alone where no type ever had it. A name
/// is that type's until another takes it; one that has given it up for good (gone) takes none.
[[nodiscard]] Expected<std::vector<TypeNameSpan>> nameSpans(Database& database, const QString& name);
/// As the types with these names, or that had them last, are called today; each once, in this order.
[[nodiscard]] Expected<QStringList> namesToday(Database& database, const QStringList& names);

} // namespace gripscope::type_state_table
