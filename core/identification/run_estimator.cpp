// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/run_estimator.h"

#include "core/identification/arx.h"
#include "core/identification/duffing.h"
#include "core/identification/instrumental_variables.h"

#include <utility>

namespace gripscope {

namespace {

/// Options of any estimator of m, b, k in continuous time: they name the same things alike.
template <typename Options>
Options continuousOptions(const PreparedRecord& record, const EstimatorTask& task)
{
    Options options;
    options.sampleTime_s = record.sampleTime_s;
    options.hold = task.hold;
    options.lag_s = record.forceLag_s;
    options.freeInitialState = task.freeInitialState;
    options.freeOffset = task.freeOffset;
    return options;
}

Estimate onRecord(Estimator estimator, const PreparedRecord& record, const EstimatorTask& task,
                  std::optional<PeriodicDiagnostics>* repetition)
{
    switch (estimator) {
    case Estimator::Arx:
    case Estimator::ArxMeanForce:
    case Estimator::Arx221:
        return estimateArx(record.force, record.position,
                           {estimator, record.sampleTime_s, record.forceLag_s, task.freeOffset});
    case Estimator::InstrumentalVariables:
        return estimateInstrumentalVariables(record.force, record.position,
                                             continuousOptions<InstrumentalVariablesOptions>(record, task));
    case Estimator::Duffing:
        return estimateDuffing(record.force, record.position,
                               continuousOptions<DuffingOptions>(record, task));
    case Estimator::Periodic: {
        PeriodicOptions options;
        options.sampleTime_s = record.sampleTime_s;
        options.hold = task.hold;
        options.lag_s = record.forceLag_s;
        options.period = task.period;
        PeriodicResult result = analysePeriodic(record.force, record.position, options);
        if (repetition != nullptr)
            *repetition = std::move(result.diagnostics);
        return result.estimate;
    }
    case Estimator::OutputError:
        break;
    }
    return estimateOutputError(record.force, record.position, outputErrorOptions(record, task));
}

} // namespace

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
    return options;
}

Estimate runEstimator(Estimator estimator, const PreparedRecord& record, const EstimatorTask& task,
                      std::optional<PeriodicDiagnostics>* repetition)
{
    const std::size_t samples = record.force.size();
    const bool takesLost = estimator == Estimator::OutputError;
    const Window part = takesLost ? Window{0, samples} : longestKnownStretch(samples, record.lost);
    EstimatorTask own = task;
    own.freeInitialState = task.freeInitialState || part.first > 0;
    Estimate estimate = part.count == samples ? onRecord(estimator, record, own, repetition)
                                              : onRecord(estimator, windowOf(record, part), own, repetition);
    estimate.part = part;
    if (repetition != nullptr && *repetition)
        (*repetition)->window.first += part.first;
    return estimate;
}

} // namespace gripscope
