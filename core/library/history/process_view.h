// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/library/records/process_values.h"
#include "core/library/sql/database.h"

namespace gripscope::process_view {

/// Inspections that a stretch goes through at the most: 0.1 s, for which storing waits.
inline constexpr int stretch = 50'000;

/// Adds the next stretch to `values`, and says where to go on. Two or three indexes that hold all that is
/// read are gone along side by side, in the order of the squeezes' keys, which is that of time: of a million
/// squeezes each takes a microsecond, where to look each one up in the tables takes ten.
[[nodiscard]] Expected<ProcessPlace> read(Database& database, const ProcessQuery& query, ProcessPlace place,
                                          ProcessValues& values);

/// Of an inspection. NotFound.
[[nodiscard]] Expected<QString> squeezeKey(Database& database, qint64 number);

} // namespace gripscope::process_view
