// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/model/estimate.h"
#include "core/identification/model/exact_step.h"

#include <vector>

namespace gripscope {

/// Exact step of m x'' + b x' + k x = F over `step_s`, state s = (x, x'):
///     s[t+1] = phi s[t] + gamma0 F[t] + gamma1 F[t+1],   gamma1 = 0 for a zero-order hold.
/// m > 0, b >= 0, k >= 0, step_s >= 0; any damping. From one matrix exponential, so that nothing cancels for
/// small steps and nothing overflows when strongly overdamped.
[[nodiscard]] ExactStep<2> discretize(const MassDampingStiffness& parameters, double step_s, ForceHold hold);

/// The positions x(t_n + lag) for a force sampled at t_n = n T, from the state (x0, v0) at t_0.
struct SimulationOptions {
    double sampleTime_s = 0;
    ForceHold hold = ForceHold::Zero;
    double lag_s = 0;
    double x0 = 0, v0 = 0, offset = 0;
};
[[nodiscard]] std::vector<double> simulate(const MassDampingStiffness& parameters,
                                           const std::vector<double>& force,
                                           const SimulationOptions& options);

} // namespace gripscope
