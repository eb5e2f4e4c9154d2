// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/model/motion_terms.h"
#include "core/signal/recording/recording.h"

#include <optional>
#include <vector>

namespace gripscope {

/// A squeeze that has not been made: even samples from a part at rest under `before`, white position noise.
struct PlannedSqueeze {
    std::vector<double> force; ///< as the gripper will command it, one value a sample
    double before = 0;         ///< the force that held the part until then
    double sampleTime_s = 0;
    ForceHold hold = ForceHold::Zero;
    double noise = 0; ///< standard deviation of a position, in its unit
};

/// The least standard deviations that an unbiased estimate can have (Cramer-Rao bound) of terms.parameters(),
/// in their order and units: the roots of the diagonal of noise^2 (J'J)^-1, J the derivatives of the
/// positions by the parameters and by what an estimator seeks of the start: x0, v0 (not with friction, which
/// holds the part), x0 - q0 with a dashpot, the offset. At the truth `values`; with friction as far as its
/// turning points stay where they are. Nothing where such a squeeze does not determine them, or where a
/// number is not usable.
[[nodiscard]] std::optional<std::vector<double>>
expectedDeviations(const MotionTerms& terms, const MotionValues& values, const PlannedSqueeze& squeeze);

} // namespace gripscope
