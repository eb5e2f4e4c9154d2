// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/model/discretization.h"

#include "core/identification/model/lag_alignment.h"

#include <cmath>

namespace gripscope {

namespace {

/// The same step in time units of the step itself and for a force of m / h^2 units: A = [[0, 1], [-k h^2/m,
/// -b h/m]], B = [0, 1]. The velocity is measured in units of `speed`, which keeps A balanced at high natural
/// frequencies.
ExactStep<2> dimensionlessStep(const MassDampingStiffness& p, double step_s, double speed, ForceHold hold)
{
    Eigen::Matrix2d a;
    a << 0, speed, -(p.k / p.m) * step_s * step_s / speed, -(p.b / p.m) * step_s;
    const Eigen::Vector2d b(0, 1 / speed);
    return exactStep<2>(a, b, hold);
}

} // namespace

ExactStep<2> discretize(const MassDampingStiffness& parameters, double step_s, ForceHold hold)
{
    ExactStep<2> out;
    if (!(step_s > 0))
        return out;
    const double naturalFrequency = std::sqrt(parameters.k / parameters.m) * step_s;
    const double speed = naturalFrequency > 1 ? naturalFrequency : 1;
    const ExactStep<2> step = dimensionlessStep(parameters, step_s, speed, hold);
    // Back from velocities in units of speed / step.
    const double velocity = speed / step_s;
    out.phi << step.phi(0, 0), step.phi(0, 1) / velocity, step.phi(1, 0) * velocity, step.phi(1, 1);
    const double compliance = step_s * step_s / parameters.m;
    out.gamma0 = compliance * Eigen::Vector2d(step.gamma0(0), step.gamma0(1) * velocity);
    out.gamma1 = compliance * Eigen::Vector2d(step.gamma1(0), step.gamma1(1) * velocity);
    return out;
}

std::vector<double> simulate(const MassDampingStiffness& parameters, const std::vector<double>& force,
                             const SimulationOptions& options)
{
    std::vector<double> position(force.size());
    LagAlignment lag(options.lag_s, options.sampleTime_s);
    const ExactStep<2> step = discretize(parameters, options.sampleTime_s, options.hold);
    const ExactStep<2> part = discretize(parameters, lag.rest * options.sampleTime_s, options.hold);
    const auto count = static_cast<std::ptrdiff_t>(force.size());
    lag.samples = std::min(lag.samples, count); // later than that the held force says no more
    const auto forceAt = [&](std::ptrdiff_t n) {
        return force[static_cast<std::size_t>(std::min(n, count - 1))];
    };

    for (std::ptrdiff_t n = 0; n < std::min(-lag.samples, count); ++n)
        position[static_cast<std::size_t>(n)] = options.x0 + options.offset;
    Eigen::Vector2d state(options.x0, options.v0);
    for (std::ptrdiff_t n = 0; n - lag.samples < count; ++n) {
        if (n >= lag.samples) {
            // A straight force reaches only the share `rest` of its way within the part of a step.
            const double end = (1 - lag.rest) * forceAt(n) + lag.rest * forceAt(n + 1);
            const double x = part.phi.row(0).dot(state) + part.gamma0(0) * forceAt(n) + part.gamma1(0) * end;
            position[static_cast<std::size_t>(n - lag.samples)] = x + options.offset;
        }
        state = step.phi * state + step.gamma0 * forceAt(n) + step.gamma1 * forceAt(n + 1);
    }
    return position;
}

} // namespace gripscope
