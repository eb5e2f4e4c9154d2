// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/library/sql/database.h"

/// How many inspections there are, in a time that does not grow with them: rows that hold how many of each
/// kind there were up to a number, and those since counted one by one. Derived from the inspections, appended
/// and never changed; verified by counting.
namespace gripscope::tally_table {

/// So many inspections are counted one by one at the most.
inline constexpr qint64 inspectionsBetween = 2000;

/// After an inspection was put in, within its transaction: a new tally where it is time for one, or none yet.
[[nodiscard]] Expected<void> keepUp(Database& database);
/// "(SELECT verdict, expected_type, type_name, n ...)" over all inspections, to be summed.
[[nodiscard]] QString countedSql();
/// Up to which number the newest tally is not what counting all finds; nothing where it is right.
[[nodiscard]] Expected<std::optional<qint64>> wrongUpTo(Database& database);

} // namespace gripscope::tally_table
