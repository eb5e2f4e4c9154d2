// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/reference_check.h"
#include "core/calibration/sensor_calibration.h"

namespace gripscope {

/// A calibration as the library keeps it.
struct CalibrationRecord : SensorCalibration {
    QString id;
    QDateTime stored;
    QString station;              ///< where it was stored
    qint64 certificateNumber = 0; ///< 1, 2, 3... at this station; 0: stored before there were numbers
};

/// How the channels of a gripper stand.
struct CalibrationsInForce {
    std::optional<CalibrationRecord> force, position;
    std::optional<ReferenceStanding> reference; ///< nothing where the gripper has no reference object
};

} // namespace gripscope
