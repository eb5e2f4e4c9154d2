// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/output_error_problem.h"

#include "core/identification/fit.h"
#include "core/identification/lost_force_prior.h"

#include <cmath>
#include <utility>

namespace gripscope {

namespace {

std::vector<std::size_t> sortedWithin(std::vector<std::size_t> lost, std::size_t count)
{
    std::sort(lost.begin(), lost.end());
    lost.erase(std::unique(lost.begin(), lost.end()), lost.end());
    lost.erase(std::lower_bound(lost.begin(), lost.end(), count), lost.end());
    return lost;
}

/// Straight lines over the lost samples, the nearest measured value before the first and after the last.
void fillLost(std::vector<double>& values, const std::vector<std::size_t>& lost)
{
    for (std::size_t i = 0; i < lost.size();) {
        std::size_t end = i + 1;
        while (end < lost.size() && lost[end] == lost[end - 1] + 1)
            ++end;
        const std::size_t first = lost[i];
        const std::size_t next = lost[end - 1] + 1;
        const bool before = first > 0;
        const bool after = next < values.size();
        const double left = before ? values[first - 1] : (after ? values[next] : 0);
        const double right = after ? values[next] : left;
        const auto span = static_cast<double>(next - first + 1);
        for (std::size_t t = first; t < next; ++t) {
            const double share = static_cast<double>(t - first + 1) / span;
            values[t] = (1 - share) * left + share * right;
        }
        i = end;
    }
}

void scaleDown(std::vector<double>& values, double scale)
{
    for (double& value : values)
        value /= scale;
}

} // namespace

OutputErrorProblem makeOutputErrorProblem(const std::vector<double>& force,
                                          const std::vector<double>& position,
                                          const OutputErrorOptions& options)
{
    OutputErrorProblem problem;
    problem.hold = options.hold;
    problem.lag = LagAlignment(options.lag_s, options.sampleTime_s);
    problem.freeInitialState = options.freeInitialState;
    problem.freeOffset = options.freeOffset;
    problem.sampleTime_s = options.sampleTime_s;
    problem.lost = sortedWithin(options.lost, force.size());
    if (problem.lost.empty()) {
        problem.force = force;
    } else {
        LostForcePrior prior = lostForcePrior(force, problem.lost);
        problem.force = std::move(prior.force);
        problem.lostForceDeviation = std::move(prior.deviation);
    }
    problem.forceScale = powerOfTwoScale(problem.force);
    scaleDown(problem.force, problem.forceScale);
    scaleDown(problem.lostForceDeviation, problem.forceScale);
    problem.position = position;
    fillLost(problem.position, problem.lost);
    if (options.freeOffset) {
        // A free offset takes any constant up; without the largest part of it less is lost to rounding.
        problem.positionShift = problem.position.front();
        for (double& value : problem.position)
            value -= problem.positionShift;
    }
    problem.positionScale = powerOfTwoScale(problem.position);
    scaleDown(problem.position, problem.positionScale);
    return problem;
}

std::ptrdiff_t OutputErrorProblem::firstRow() const
{
    return std::max<std::ptrdiff_t>(-lag.samples, 0);
}

std::ptrdiff_t OutputErrorProblem::endRow() const
{
    const auto count = static_cast<std::ptrdiff_t>(force.size());
    // Within the last step a straight force would need the sample after it.
    const std::ptrdiff_t unknown = lag.rest > 0 && hold == ForceHold::First ? 1 : 0;
    return std::min(count - lag.samples - unknown, count);
}

std::ptrdiff_t OutputErrorProblem::measuredRows() const
{
    const std::ptrdiff_t all = rows();
    if (all == 0)
        return 0;
    const auto first = std::lower_bound(lost.begin(), lost.end(), static_cast<std::size_t>(firstRow()));
    const auto end = std::lower_bound(first, lost.end(), static_cast<std::size_t>(endRow()));
    return all - (end - first);
}

MassDampingStiffness OutputErrorProblem::toChannelUnits(const Eigen::Vector3d& theta) const
{
    const double scale = forceScale / positionScale;
    return {std::exp(theta(0)) * sampleTime_s * sampleTime_s * scale,
            std::exp(theta(1)) * sampleTime_s * scale, std::exp(theta(2)) * scale};
}

Eigen::Vector3d OutputErrorProblem::toTheta(const MassDampingStiffness& parameters) const
{
    const double scale = std::log(forceScale / positionScale);
    const double time = std::log(sampleTime_s);
    return {std::log(parameters.m) - 2 * time - scale, std::log(parameters.b) - time - scale,
            std::log(parameters.k) - scale};
}

} // namespace gripscope
