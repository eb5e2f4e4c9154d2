// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/model/discretization.h"
#include "core/identification/motion/motion_search.h"

namespace gripscope {

namespace {

KnownForces withForces(const CompletedRecord& completed, const MotionOptions& options)
{
    return {completed, MotionProblem{completedProblem(completed, options), options.terms},
            completed.errorFactor};
}

} // namespace

KnownForces knownForces(const std::vector<double>& force, const std::vector<double>& position,
                        const MotionOptions& options)
{
    const CompletedRecord completed = completedRecord(force, position, options);
    const bool others = !options.terms.mass || !options.terms.spring;
    if (options.lost.empty() || completed.outputError.parameters || !others)
        return withForces(completed, options);
    KnownForces straight;
    straight.problem = {makeOutputErrorProblem(force, position, options), options.terms};
    return straight;
}

std::optional<KnownForces> knownForcesAgain(const KnownForces& known, const Estimate& found,
                                            const MotionOptions& options)
{
    const CompletedRecord& before = known.completed;
    if (before.lost.empty() || !found.parameters)
        return std::nullopt;
    const Nuisance& n = found.nuisance;
    const std::vector<double> linear = simulate(*found.parameters, before.force,
                                                {options.sampleTime_s, options.hold, options.lag_s,
                                                 n.x0.value_or(0), n.v0.value_or(0), n.offset.value_or(0)});
    std::vector<double> position = before.position;
    for (std::size_t i = 0; i < position.size(); ++i)
        position[i] -= found.simulated[i] - linear[i];
    ContinuousTimeOptions asked = options;
    asked.start = found.parameters;
    CompletedRecord again = completedRecord(before.force, position, asked);
    again.position = before.position;
    if (!again.outputError.parameters)
        return std::nullopt;
    return withForces(again, options);
}

} // namespace gripscope
