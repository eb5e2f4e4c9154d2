// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/sensor_calibration.h"

namespace gripscope {

/// A calibration as the library keeps it.
struct CalibrationRecord : SensorCalibration {
    QString id;
    QDateTime stored;
};

struct CalibrationsInForce {
    std::optional<CalibrationRecord> force, position;
};

} // namespace gripscope
