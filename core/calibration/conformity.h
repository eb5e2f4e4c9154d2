// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/sensor_calibration.h"

namespace gripscope {

/// Loads that the gripper said less those that were put on, in the order of the points, in the channel's
/// unit.
struct LoadErrors {
    std::vector<double> each;
    double largest = 0; ///< magnitude
};

/// As the channel was found: by what corrected it until then. Nothing where that was not recorded.
[[nodiscard]] std::optional<LoadErrors> errorsAsFound(const SensorCalibration& calibration);
/// As it is left: by the new curve; of the check points where there are any, else of the points that it was
/// fitted to.
[[nodiscard]] LoadErrors errorsAsLeft(const SensorCalibration& calibration,
                                      const CalibrationEvaluation& evaluation);

enum class CalibrationConformity { Conforms, DoesNotConform, Undecided };

/// Guarded: conforms where error + U <= tolerance, does not where error - U > tolerance, undecided between
/// (guard band U, ILAC-G8:09/2019, 4.2.3). Simple: conforms where error <= tolerance, else does not.
[[nodiscard]] CalibrationConformity judgeConformity(double largestError, double expandedUncertainty,
                                                    double tolerance, DecisionRule rule);

/// Mean readings at one load, reached from below and from above.
struct UpAndDown {
    double load = 0;
    std::optional<double> up, down;
};
/// Of all loads of the points, ascending.
[[nodiscard]] std::vector<UpAndDown> upAndDown(const std::vector<CalibrationPoint>& points);

} // namespace gripscope
