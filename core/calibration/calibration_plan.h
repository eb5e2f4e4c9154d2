// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/sensor_calibration.h"

namespace gripscope {

/// How a calibration is to be taken.
struct CalibrationPlan {
    SensorChannel channel = SensorChannel::Force;
    std::vector<double> loads{0, 10, 20, 30, 40, 50}; ///< in the channel's unit, ascending, all different
    int runs = 2;                                     ///< each up and, where wanted, down again
    bool descending = true;
    int degree = 1;
    CalibrationReference reference;
    double averaging_s = 1;
    bool loadsAreRead = false; ///< from a load cell at each point; those of the plan are what to aim at
};

struct PlannedPoint {
    double load = 0;
    int run = 1;           ///< counted from 1
    bool ascending = true; ///< reached from below
};

/// Why a plan cannot be carried out, and what would do; nothing when it can.
[[nodiscard]] std::optional<Error> problemOf(const CalibrationPlan& plan);

/// Up through all loads and down again, as often as there are runs. A run begins where the one before ended:
/// that load is not taken twice. Without descending each run starts at the least load again.
[[nodiscard]] std::vector<PlannedPoint> plannedPoints(const CalibrationPlan& plan);

} // namespace gripscope
