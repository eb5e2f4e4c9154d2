// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/model/discretization.h"
#include "core/identification/motion/motion.h"

#include <boost/numeric/odeint.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace gripscope::test {

/// The positions that m x'' + b x' + k x + k3 x^3 = F gives, conventions as for simulate(), by an adaptive
/// method of order 8 (Fehlberg 7(8)) with tolerances near rounding. Not for softening springs that let go.
inline std::vector<double> simulateDuffing(const MassDampingStiffness& parameters, double k3,
                                           const std::vector<double>& force, const SimulationOptions& options)
{
    namespace odeint = boost::numeric::odeint;
    using State = std::array<double, 2>; // position, and speed over that of the part's own swing
    const double swing = std::sqrt(parameters.k / parameters.m);
    double size = std::abs(options.x0) + std::abs(options.v0) / swing;
    for (const double value : force)
        size = std::max(size, std::abs(value) / parameters.k);
    const auto count = static_cast<std::ptrdiff_t>(force.size());
    const double step = options.sampleTime_s;
    const auto whole = static_cast<std::ptrdiff_t>(std::floor(options.lag_s / step));
    const double rest = options.lag_s / step - static_cast<double>(whole);
    std::vector<double> positions(force.size(), options.x0 + options.offset);
    State state{options.x0, options.v0 / swing};
    auto stepper = odeint::make_controlled(1e-13 * size, 1e-13, odeint::runge_kutta_fehlberg78<State>());
    for (std::ptrdiff_t n = 0; n - whole < count; ++n) {
        const double from = force[static_cast<std::size_t>(std::min(n, count - 1))];
        const double to = options.hold == ForceHold::First
                              ? force[static_cast<std::size_t>(std::min(n + 1, count - 1))]
                              : from;
        const auto motion = [&](const State& s, State& slope, double t) {
            const double f = from + (to - from) * t / step;
            slope = {swing * s[1],
                     (f - parameters.b * swing * s[1] - parameters.k * s[0] - k3 * s[0] * s[0] * s[0]) /
                         parameters.m / swing};
        };
        const auto run = [&](double begin, double end) {
            if (end > begin)
                odeint::integrate_adaptive(stepper, motion, state, begin, end, (end - begin) / 4);
        };
        run(0, rest * step);
        if (n >= whole)
            positions[static_cast<std::size_t>(n - whole)] = state[0] + options.offset;
        run(rest * step, step);
    }
    return positions;
}

inline MotionOptions duffingOptions(double sampleTime_s)
{
    MotionOptions options;
    options.sampleTime_s = sampleTime_s;
    options.estimator = Estimator::Duffing;
    options.terms.cubic = true;
    return options;
}

inline double cubicOf(const Estimate& estimate)
{
    return estimate.motion->values[MotionParameter::Cubic];
}

} // namespace gripscope::test
