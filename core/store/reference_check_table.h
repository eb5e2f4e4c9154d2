// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/reference_check.h"
#include "core/store/statement.h"

#include <vector>

namespace gripscope::reference_check_table {

[[nodiscard]] Expected<void> insert(Database& database, const RowStamp& stamp, const ReferenceCheck& check);
/// Of this gripper, newest first.
[[nodiscard]] Expected<std::vector<ReferenceCheckRecord>> read(Database& database,
                                                               const QString& gripperSerial, int limit);
/// The newest on that object which passed or failed.
[[nodiscard]] Expected<std::optional<ReferenceCheckRecord>> newest(Database& database,
                                                                   const ReferenceObjectRecord& reference);

} // namespace gripscope::reference_check_table
