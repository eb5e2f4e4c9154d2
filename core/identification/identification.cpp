// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/identification.h"

#include "core/identification/arx.h"
#include "core/identification/duffing.h"
#include "core/identification/fit.h"
#include "core/identification/output_error.h"
#include "core/identification/periodic.h"
#include "core/identification/validity_checks.h"

#include <cmath>

namespace gripscope {

namespace {

std::vector<double> part(const std::vector<double>& all, Window window)
{
    if (all.size() < window.first + window.count)
        return {};
    const auto begin = all.begin() + static_cast<std::ptrdiff_t>(window.first);
    return {begin, begin + static_cast<std::ptrdiff_t>(window.count)};
}

Estimate notApplicable(Estimator estimator, const char* message)
{
    Estimate estimate;
    estimate.estimator = estimator;
    estimate.message = message;
    return estimate;
}

OutputErrorOptions outputErrorOptions(const Identification& data, double lag_s,
                                      const IdentificationOptions& options)
{
    OutputErrorOptions outputError;
    outputError.sampleTime_s = data.sampleTime_s;
    outputError.hold = data.hold;
    outputError.lag_s = lag_s;
    outputError.freeInitialState = options.initialState == InitialState::Free;
    outputError.freeOffset = options.freeOffset;
    return outputError;
}

DuffingOptions duffingOptions(const Identification& data, double lag_s, const IdentificationOptions& options)
{
    DuffingOptions duffing;
    duffing.sampleTime_s = data.sampleTime_s;
    duffing.hold = data.hold;
    duffing.lag_s = lag_s;
    duffing.freeInitialState = options.initialState == InitialState::Free;
    duffing.freeOffset = options.freeOffset;
    return duffing;
}

Estimate runPeriodic(const Identification& data, const Recording& recording)
{
    PeriodicOptions periodic;
    periodic.sampleTime_s = data.sampleTime_s;
    periodic.hold = data.hold;
    periodic.lag_s = recording.forceLag_s;
    periodic.period = excitationPeriod(recording);
    return estimatePeriodic(data.force, data.position, periodic);
}

Estimate runEstimator(Estimator estimator, const Identification& data, const Recording& recording,
                      const IdentificationOptions& options)
{
    const double lag_s = recording.forceLag_s;
    switch (estimator) {
    case Estimator::Arx:
    case Estimator::ArxMeanForce:
    case Estimator::Arx221:
        return estimateArx(data.force, data.position,
                           {estimator, data.sampleTime_s, lag_s, options.freeOffset});
    case Estimator::OutputError:
        return estimateOutputError(data.force, data.position, outputErrorOptions(data, lag_s, options));
    case Estimator::Duffing:
        return estimateDuffing(data.force, data.position, duffingOptions(data, lag_s, options));
    case Estimator::Periodic:
        return runPeriodic(data, recording);
    case Estimator::InstrumentalVariables:
        break;
    }
    return notApplicable(estimator, "this estimator is not part of this version");
}

/// N/2 ln(SSE / SSE of the other hold), N counted as far as the residuals are independent.
std::optional<double> otherHoldGain(const Identification& data, double lag_s,
                                    const IdentificationOptions& options)
{
    const Estimate* const estimate = data.find(Estimator::OutputError);
    if (estimate == nullptr || estimate->status != EstimateStatus::Converged ||
        !estimate->residuals.whitenessP)
        return std::nullopt;
    const std::optional<double> other = sseUnderOtherHold(
        data.force, data.position, outputErrorOptions(data, lag_s, options), *estimate->parameters);
    if (!other || !(*other > 0))
        return std::nullopt;
    const double inflation = std::max(estimate->residuals.errorInflation.value_or(1), 1.0);
    const double independent = estimate->residuals.degreesOfFreedom / (inflation * inflation);
    const double gain = independent / 2 * std::log(estimate->residuals.sse / *other);
    return std::isfinite(gain) ? std::optional(gain) : std::nullopt;
}

/// What keeps every estimator from starting, or nothing.
const char* unusable(const Identification& data, const Recording& recording)
{
    if (recording.force.size() != recording.position.size())
        return "force and position have different lengths";
    if (!std::isfinite(data.sampleTime_s) || !(data.sampleTime_s > 0) || !std::isfinite(recording.forceLag_s))
        return "the sample time or the lag is not a usable number";
    if (!allFinite(data.force) || !allFinite(data.position))
        return "the recording holds values that are not finite";
    return nullptr;
}

/// Output error where it converged; else the estimate with parameters that simulates best.
Estimator recommend(const std::vector<Estimate>& estimates)
{
    const Estimate* best = nullptr;
    for (const Estimate& estimate : estimates) {
        if (!estimate.parameters)
            continue;
        if (estimate.estimator == Estimator::OutputError && estimate.status == EstimateStatus::Converged)
            return estimate.estimator;
        const auto fit = [](const Estimate& e) { return e.fit.simulationPercent.value_or(-1e300); };
        if (best == nullptr || fit(estimate) > fit(*best))
            best = &estimate;
    }
    if (best != nullptr)
        return best->estimator;
    return estimates.empty() ? Estimator::OutputError : estimates.back().estimator;
}

} // namespace

const Estimate* Identification::find(Estimator estimator) const
{
    for (const Estimate& estimate : estimates) {
        if (estimate.estimator == estimator)
            return &estimate;
    }
    return nullptr;
}

const Estimate* Identification::best() const
{
    const Estimate* estimate = find(recommended);
    return estimate != nullptr && estimate->parameters ? estimate : nullptr;
}

Identification identify(const Recording& recording, const IdentificationOptions& options)
{
    Identification result;
    result.choice = chooseWindow(recording);
    result.hold = options.hold.value_or(recording.hold.value_or(ForceHold::First));
    result.sampleTime_s = recording.sampleTime_s;
    result.time_s = part(recording.time_s, result.choice.window);
    result.force = part(recording.force, result.choice.window);
    result.position = part(recording.position, result.choice.window);

    const char* const obstacle = unusable(result, recording);
    for (const Estimator estimator : options.estimators) {
        result.estimates.push_back(obstacle != nullptr ? notApplicable(estimator, obstacle)
                                                       : runEstimator(estimator, result, recording, options));
    }
    result.recommended = recommend(result.estimates);
    if (result.recommended == Estimator::OutputError && obstacle == nullptr)
        result.otherHoldGain = otherHoldGain(result, recording.forceLag_s, options);
    result.validity.checks = checkValidity(result, recording, options);
    result.validity.verdict = overallVerdict(result.validity.checks);
    return result;
}

} // namespace gripscope
