// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/motion/expected_deviations.h"

#include "core/identification/motion/motion_search.h"
#include "core/math/decompositions.h"
#include "core/math/fit.h"
#include "core/math/least_squares.h"

#include <algorithm>
#include <cmath>

namespace gripscope {

namespace {

using P = MotionParameter;

/// Where the spring holds the force, by Newton's method from the straight spring's answer.
double restUnder(double force, const MotionTerms& terms, const MotionValues& values)
{
    constexpr int iterations = 50;
    const double k = values[P::Stiffness];
    const double k3 = terms.cubic ? values[P::Cubic] : 0;
    double x = force / k;
    for (int i = 0; i < iterations && k3 != 0; ++i)
        x -= (x * (k + k3 * x * x) - force) / (k + 3 * k3 * x * x);
    return x;
}

/// In units of its own, of which positions are about 1.
MotionProblem problemOf(const MotionTerms& terms, const MotionValues& values, const PlannedSqueeze& squeeze)
{
    MotionProblem problem;
    problem.terms = terms;
    problem.hold = squeeze.hold;
    problem.sampleTime_s = squeeze.sampleTime_s;
    problem.startsAtRest = terms.friction;
    problem.forceScale = powerOfTwoScale(squeeze.force);
    const double softest = terms.spring ? values[P::Stiffness] : values[P::Damping] / squeeze.sampleTime_s;
    const double position = problem.forceScale / softest;
    problem.positionScale = powerOfTwoScale({&position, 1});
    problem.force = squeeze.force;
    for (double& value : problem.force)
        value /= problem.forceScale;
    problem.position.assign(problem.force.size(), 0);
    return problem;
}

} // namespace

std::optional<std::vector<double>> expectedDeviations(const MotionTerms& terms, const MotionValues& values,
                                                      const PlannedSqueeze& squeeze)
{
    const bool usable = allFinite(squeeze.force) && squeeze.sampleTime_s > 0 && squeeze.noise > 0 &&
                        std::isfinite(squeeze.before) && std::isfinite(squeeze.noise);
    if (!usable || squeeze.force.empty())
        return std::nullopt;
    const MotionProblem problem = problemOf(terms, values, squeeze);
    MotionPoint truth;
    truth.values = inProblemUnits(problem, values);
    if (terms.spring)
        truth.x0 = restUnder(squeeze.before, terms, values) / problem.positionScale;
    if (problem.measuredRows() <= problem.unknowns() || !truth.isPhysical(terms))
        return std::nullopt;
    MotionSearchResult there;
    there.linear = linearize(problem, truth);
    const std::vector<P> parameters = terms.parameters();
    if (!there.isDetermined())
        return std::nullopt;
    const Eigen::MatrixXd inverse =
        inverseOfTriangle(triangleOf(there.linear.triangle(Eigen::all, there.linear.moving())));
    std::vector<double> deviations;
    for (std::size_t i = 0; i < parameters.size(); ++i) {
        const P parameter = parameters[i];
        const double unit = isPositive(parameter) ? values[parameter] : problem.unitOf(parameter);
        const auto row = inverse.rows() - static_cast<Eigen::Index>(parameters.size() - i);
        deviations.push_back(squeeze.noise / problem.positionScale * unit * inverse.row(row).norm());
    }
    return std::ranges::all_of(deviations, [](double d) { return std::isfinite(d); })
               ? std::optional(deviations)
               : std::nullopt;
}

} // namespace gripscope
