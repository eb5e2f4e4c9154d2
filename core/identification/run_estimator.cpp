// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/run_estimator.h"

#include "core/identification/arx.h"
#include "core/identification/duffing.h"
#include "core/identification/instrumental_variables.h"
#include "core/identification/periodic.h"

namespace gripscope {

namespace {

struct Stretch {
    Window part;
    std::vector<double> force, position;
    EstimatorTask task;
};

Stretch longestStretch(const PreparedRecord& record, EstimatorTask task)
{
    const Window part = longestKnownStretch(record.force.size(), record.lost);
    const auto cut = [&](const std::vector<double>& all) {
        const auto begin = all.begin() + static_cast<std::ptrdiff_t>(part.first);
        return std::vector<double>(begin, begin + static_cast<std::ptrdiff_t>(part.count));
    };
    task.freeInitialState = task.freeInitialState || part.first > 0;
    return {part, cut(record.force), cut(record.position), task};
}

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

Estimate onStretch(Estimator estimator, const PreparedRecord& record, const Stretch& s)
{
    switch (estimator) {
    case Estimator::Arx:
    case Estimator::ArxMeanForce:
    case Estimator::Arx221:
        return estimateArx(s.force, s.position,
                           {estimator, record.sampleTime_s, record.forceLag_s, s.task.freeOffset});
    case Estimator::InstrumentalVariables:
        return estimateInstrumentalVariables(s.force, s.position,
                                             continuousOptions<InstrumentalVariablesOptions>(record, s.task));
    case Estimator::Duffing:
        return estimateDuffing(s.force, s.position, continuousOptions<DuffingOptions>(record, s.task));
    case Estimator::Periodic: {
        PeriodicOptions options;
        options.sampleTime_s = record.sampleTime_s;
        options.hold = s.task.hold;
        options.lag_s = record.forceLag_s;
        options.period = s.task.period;
        return estimatePeriodic(s.force, s.position, options);
    }
    case Estimator::OutputError: // takes the whole record
        break;
    }
    Estimate none;
    none.estimator = estimator;
    none.message = "this estimator is not part of this version";
    return none;
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

Estimate runEstimator(Estimator estimator, const PreparedRecord& record, const EstimatorTask& task)
{
    if (estimator == Estimator::OutputError) {
        Estimate estimate =
            estimateOutputError(record.force, record.position, outputErrorOptions(record, task));
        estimate.part = {0, record.force.size()};
        return estimate;
    }
    const Stretch stretch = longestStretch(record, task);
    Estimate estimate = onStretch(estimator, record, stretch);
    estimate.part = stretch.part;
    return estimate;
}

} // namespace gripscope
