// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/reference_check.h"
#include "core/store/statement.h"

#include <vector>

namespace gripscope::reference_table {

[[nodiscard]] Expected<void> insert(Database& database, const RowStamp& stamp,
                                    const ReferenceObject& reference);
/// The newest of this gripper.
[[nodiscard]] Expected<std::optional<ReferenceObjectRecord>> newest(Database& database,
                                                                    const QString& gripperSerial);
[[nodiscard]] Expected<std::optional<ReferenceObjectRecord>> find(Database& database, const QString& id);
/// All of this gripper.
[[nodiscard]] Expected<std::vector<ReferenceObjectRecord>> read(Database& database,
                                                                const QString& gripperSerial);

} // namespace gripscope::reference_table
