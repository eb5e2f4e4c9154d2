// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/duffing/duffing_model.h"
#include "core/identification/model/discretization.h"
#include "core/math/fit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace gripscope::test {

/// The positions that m x'' + b x' + k x + k3 x^3 = F gives, conventions as for simulate(): the estimator's
/// own integration, its steps halved until that changes positions of about 1 by less than 1e-10. Empty when
/// m, b, k are not positive numbers, or when a softening spring lets go.
inline std::vector<double> simulateDuffing(const MassDampingStiffness& parameters, double k3,
                                           const std::vector<double>& force, const SimulationOptions& options)
{
    constexpr double exact = 1e-10;
    constexpr int mostSubsteps = 256;
    DuffingProblem problem;
    problem.hold = options.hold;
    problem.lag = LagAlignment(options.lag_s, options.sampleTime_s);
    problem.sampleTime_s = options.sampleTime_s;
    problem.forceScale = powerOfTwoScale(force);
    problem.force = force;
    for (double& value : problem.force)
        value /= problem.forceScale;
    const double swing = options.v0 * std::sqrt(parameters.m / parameters.k);
    const std::array<double, 3> sizes{problem.forceScale / parameters.k, options.x0, swing};
    problem.positionScale = powerOfTwoScale(sizes);
    DuffingPoint point;
    point.theta = problem.toTheta(parameters);
    point.cubic = k3 / cubicUnit(problem);
    point.x0 = options.x0 / problem.positionScale;
    point.v0 = options.v0 * problem.sampleTime_s / problem.positionScale;
    problem.substeps = suitableSubsteps(point, 1);
    std::vector<double> positions = positionsAt(problem, point);
    while (!positions.empty() && problem.substeps <= mostSubsteps) {
        problem.substeps *= 2;
        const std::vector<double> finer = positionsAt(problem, point);
        double change = 0;
        for (std::size_t i = 0; i < finer.size(); ++i)
            change = std::max(change, std::abs(finer[i] - positions[i]));
        positions = finer;
        if (change < exact)
            break;
    }
    for (double& x : positions)
        x = x * problem.positionScale + options.offset;
    return positions;
}

} // namespace gripscope::test
