// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/estimators/run_estimator.h"

#include "core/identification/estimators/estimator_table.h"
#include "core/identification/quasistatic/held_stiffness.h"

namespace gripscope {

Window longestKnownStretch(std::size_t samples, const std::vector<std::size_t>& lost)
{
    Window longest;
    std::size_t first = 0;
    const auto close = [&](std::size_t end) {
        if (end - first > longest.count)
            longest = {first, end - first};
    };
    for (const std::size_t index : lost) {
        close(index);
        first = index + 1;
    }
    close(samples);
    return longest;
}

OutputErrorOptions outputErrorOptions(const PreparedRecord& record, const EstimatorTask& task)
{
    auto options = continuousOptions<OutputErrorOptions>(record, task);
    options.lost = record.lost;
    options.residuals = task.residuals;
    return options;
}

MotionOptions motionOptions(Estimator estimator, const PreparedRecord& record, const EstimatorTask& task)
{
    auto options = continuousOptions<MotionOptions>(record, task);
    options.lost = record.lost;
    options.estimator = estimator;
    options.terms = motionTermsOf(estimator).value_or(MotionTerms());
    if (options.terms.friction &&
        options.terms.spring) // without a part it is the gripper's that is looked for
        options.knownFriction = record.chain.friction;
    if (task.near != nullptr && task.near->parameters && task.near->motion) {
        options.start = task.near->parameters;
        options.startNuisance = task.near->nuisance;
        options.startTerms = task.near->motion->values;
        options.startIsNear = true;
        options.arrived = nearEnough;
    }
    return options;
}

Estimate runEstimator(Estimator estimator, const PreparedRecord& record, const EstimatorTask& task,
                      std::optional<PeriodicDiagnostics>* repetition)
{
    const std::size_t samples = record.force.size();
    if (record.held) {
        Estimate estimate = estimator == Estimator::Static ? estimateHeldStiffness(*record.held, record.chain)
                                                           : notOfHeldPosition(estimator, *record.held);
        estimate.part = {0, samples};
        return estimate;
    }
    const EstimatorFacts& facts = factsOf(estimator);
    const Window part = facts.takesLost ? Window{0, samples} : longestKnownStretch(samples, record.lost);
    EstimatorTask own = task;
    own.freeInitialState = task.freeInitialState || part.first > 0;
    Estimate estimate = part.count == samples ? facts.run(estimator, record, own, repetition)
                                              : facts.run(estimator, windowOf(record, part), own, repetition);
    estimate.part = part;
    if (repetition != nullptr && *repetition)
        (*repetition)->window.first += part.first;
    return estimate;
}

} // namespace gripscope
