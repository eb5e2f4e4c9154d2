// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/calibration_record.h"
#include "core/store/library.h"

namespace gripscope {

/// A force channel against weights, made up for demonstrations: 1.2 % too high, with a little hysteresis.
[[nodiscard]] SensorCalibration exampleCalibration();
/// A spring for the virtual gripper, whose can A stands in for it.
[[nodiscard]] ReferenceObject exampleReference();
/// These in the library, with some checks on the spring.
[[nodiscard]] Expected<void> storeExamples(Library& library);

} // namespace gripscope
