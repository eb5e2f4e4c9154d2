// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/calibration_record.h"
#include "core/store/statement.h"

namespace gripscope::calibration_table {

[[nodiscard]] Expected<void> insert(Database& database, const RowStamp& stamp,
                                    const SensorCalibration& calibration);
/// Of this gripper, both channels, newest first; all grippers' where the serial number is empty.
[[nodiscard]] Expected<std::vector<CalibrationRecord>> read(Database& database, const QString& gripperSerial,
                                                            int limit);
/// The newest of each channel.
[[nodiscard]] Expected<CalibrationsInForce> inForce(Database& database, const QString& gripperSerial);

} // namespace gripscope::calibration_table
