// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/calibration_record.h"
#include "core/calibration/reference_check.h"
#include "core/library/records/measuring_chain_record.h"
#include "core/library/sql/statement.h"

#include <vector>

namespace gripscope::calibration_table {

[[nodiscard]] Expected<void> insert(Database& database, const RowStamp& stamp,
                                    const SensorCalibration& calibration);
/// Of this gripper, both channels, newest first; all grippers' where the serial number is empty.
[[nodiscard]] Expected<std::vector<CalibrationRecord>> read(Database& database, const QString& gripperSerial,
                                                            int limit);
/// The newest of each channel.
[[nodiscard]] Expected<CalibrationsInForce> inForce(Database& database, const QString& gripperSerial);

} // namespace gripscope::calibration_table

namespace gripscope::measuring_chain_table {

[[nodiscard]] Expected<void> insert(Database& database, const RowStamp& stamp,
                                    const NewMeasuringChain& measured);
/// Of this gripper, newest first.
[[nodiscard]] Expected<std::vector<MeasuringChainRecord>> list(Database& database,
                                                               const QString& gripperSerial, int limit);
/// The newest of this gripper.
[[nodiscard]] Expected<std::optional<MeasuringChainRecord>> newest(Database& database,
                                                                   const QString& gripperSerial);

} // namespace gripscope::measuring_chain_table

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

namespace gripscope::reference_check_table {

[[nodiscard]] Expected<void> insert(Database& database, const RowStamp& stamp, const ReferenceCheck& check);
/// Of this gripper, newest first.
[[nodiscard]] Expected<std::vector<ReferenceCheckRecord>> read(Database& database,
                                                               const QString& gripperSerial, int limit);
/// The newest on that object which passed or failed.
[[nodiscard]] Expected<std::optional<ReferenceCheckRecord>> newest(Database& database,
                                                                   const ReferenceObjectRecord& reference);

} // namespace gripscope::reference_check_table
