// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/reference_check.h"
#include "core/calibration/sensor_calibration.h"

namespace gripscope {

/// A calibration as the library keeps it.
struct CalibrationRecord : SensorCalibration {
    QString id;
    QDateTime stored;
};

/// How the channels of a gripper stand.
struct CalibrationsInForce {
    std::optional<CalibrationRecord> force, position;
    std::optional<ReferenceStanding> reference; ///< nothing where the gripper has no reference object
};

} // namespace gripscope
