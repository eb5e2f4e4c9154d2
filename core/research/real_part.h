// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/signal/recording/recording.h"

#include <vector>

namespace gripscope {

/// A part as there are some, between the jaws of a gripper that has friction:
///     m x'' + b x' + k x + k3 x^3 + k1 (x - q) + Fc s(x') + Fh z = F,  tau q' = x - q,
///     d z' = x' - |x'| z  (hysteresis, Bouc 1967 and Wen 1976).
/// k1, Fc, Fh and k3 may be zero; then there is no such term.
struct RealPart {
    double m = 0, b = 0, k = 0;
    double friction = 0;                           ///< Fc
    double relaxing = 0, relaxationTime_s = 0.05;  ///< k1, tau
    double cubic = 0;                              ///< k3
    double hysteresis = 0, hysteresisReach = 1e-4; ///< Fh, d
};

/// Where the part is at `times_s` (rising) under a force known at `forceTimes_s` (rising) and held as
/// declared between them, from rest under the first force: in equilibrium, the dashpot relaxed. Fourth-order
/// Runge-Kutta in steps of at most `step_s`, turning points and the end of sticking found within them. It
/// shares nothing with the estimators, and is there to tell how true they are. 1 us: to 1e-6 of the motion.
[[nodiscard]] std::vector<double> simulateRealPart(const RealPart& part,
                                                   const std::vector<double>& forceTimes_s,
                                                   const std::vector<double>& force, ForceHold hold,
                                                   const std::vector<double>& times_s, double step_s = 5e-6);

} // namespace gripscope
