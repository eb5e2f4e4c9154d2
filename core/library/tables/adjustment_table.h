// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/library/records/gripper_adjustment.h"
#include "core/library/sql/statement.h"

#include <QMap>

#include <vector>

namespace gripscope::adjustment_table {

[[nodiscard]] Expected<void> insert(Database& database, const RowStamp& stamp,
                                    const NewAdjustment& adjustment, qint64 libraryVersion);
[[nodiscard]] Expected<void> insertEnd(Database& database, const QString& id, const QString& reason,
                                       const QString& operatorName);
[[nodiscard]] Expected<std::optional<AdjustmentRecord>> find(Database& database, const QString& id);
[[nodiscard]] Expected<std::vector<AdjustmentRecord>> newest(Database& database, int limit);
/// Of this gripper.
[[nodiscard]] Expected<std::optional<AdjustmentRecord>> inForce(Database& database,
                                                                const QString& gripperSerial);
[[nodiscard]] Expected<std::vector<AdjustmentRecord>> allInForce(Database& database);
/// Names of the types in use with the serial numbers that their accepted squeezes name.
[[nodiscard]] Expected<QMap<QString, QStringList>> grippersOfTypes(Database& database);

} // namespace gripscope::adjustment_table
