// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/identification.h"

#include "core/identification/assessment.h"
#include "core/identification/fit.h"
#include "core/identification/identifiability.h"
#include "core/identification/output_error.h"
#include "core/identification/run_estimator.h"
#include "core/identification/validation_records.h"
#include "core/identification/validity_checks.h"
#include "core/words.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace gripscope {

namespace {

/// What keeps every estimator from starting, or nothing.
const char* unusable(const PreparedRecord& record)
{
    if (record.force.size() != record.position.size())
        return QT_TRANSLATE_NOOP("Words", "force and position have different lengths");
    if (!std::isfinite(record.sampleTime_s) || !(record.sampleTime_s > 0) ||
        !std::isfinite(record.forceLag_s))
        return QT_TRANSLATE_NOOP("Words", "the sample time or the lag is not a usable number");
    if (!allFinite(record.force) || !allFinite(record.position))
        return QT_TRANSLATE_NOOP("Words", "the recording holds values that are not finite");
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

/// Asked for, found, and decisively better than a linear spring.
bool cubicIsBetter(const Identification& data)
{
    const Estimate* const duffing = data.find(Estimator::Duffing);
    return duffing != nullptr && duffing->status == EstimateStatus::Converged && data.comparison.decisive &&
           data.comparison.ranked.front().id == QLatin1String("cubic_spring");
}

bool failed(const std::vector<ValidityCheck>& checks, const QString& id)
{
    return std::any_of(checks.begin(), checks.end(),
                       [&](const ValidityCheck& check) { return check.id == id && !check.ok; });
}

/// The estimator that the checks on the recommended one ask for instead, where it was run and found
/// something.
Estimator reconsidered(const Identification& data)
{
    const Estimate* const periodic = data.find(Estimator::Periodic);
    if (periodic != nullptr && periodic->status == EstimateStatus::Converged &&
        failed(data.validity.checks, QStringLiteral("feedback")))
        return Estimator::Periodic;
    return cubicIsBetter(data) ? Estimator::Duffing : data.recommended;
}

/// Without the empty gripper nothing may be left: then there is no object to speak of.
void judgeBaseline(Identification& data)
{
    if (data.best() == nullptr || data.object())
        return;
    for (ValidityCheck& check : data.validity.checks) {
        if (check.id != QLatin1String("physical_range"))
            continue;
        check.ok = false;
        check.decisive = true;
        check.message = Words::tr(
            "the squeeze is not told from the empty gripper: with its m, b and k taken off, not all that is "
            "left is above zero. Check that the part was between the fingers, and measure the empty gripper "
            "again");
    }
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

HoldEvidence holdDeclaration(const Recording& recording, const IdentificationOptions& options)
{
    HoldEvidence declaration;
    declaration.declared = options.hold.value_or(recording.hold.value_or(ForceHold::First));
    declaration.lag_s = recording.forceLag_s;
    declaration.lagUncertainty_s = recording.chain.forceLagUncertainty_s;
    return declaration;
}

const HoldEvidence& Identification::tellingHold() const
{
    const bool alone = holdEvidence.verdict() == HoldVerdict::Contradicts &&
                       summedHold.verdict() != HoldVerdict::Contradicts;
    return alone ? holdEvidence : summedHold;
}

std::optional<CorrectedParameters> Identification::object() const
{
    const Estimate* estimate = best();
    if (estimate == nullptr)
        return std::nullopt;
    const Eigen::Matrix3d covariance = estimate->covariance.value_or(Eigen::Matrix3d::Zero());
    if (baseline)
        return withoutGripper(*estimate->parameters, covariance, *baseline);
    return CorrectedParameters{*estimate->parameters, covariance};
}

Identification identify(const Recording& recording, const IdentificationOptions& options)
{
    PreparationOptions preparation;
    preparation.hold = options.hold;
    const PreparedRecord record = prepare(recording, preparation);
    Identification result;
    result.choice = record.choice;
    result.holdEvidence = holdDeclaration(recording, options);
    result.hold = result.holdEvidence.declared;
    result.sampleTime_s = record.sampleTime_s;
    result.baseline = recording.chain.baseline;
    const EstimatorTask task{result.hold, options.initialState == InitialState::Free, options.freeOffset,
                             excitationPeriod(recording)};

    const char* const obstacle = unusable(record);
    for (const Estimator estimator : options.estimators)
        result.estimates.push_back(
            obstacle != nullptr
                ? statusOnly(estimator, EstimateStatus::NotApplicable, obstacle)
                : runEstimator(estimator, record, task,
                               estimator == Estimator::Periodic ? &result.repetition : nullptr));
    result.recommended = recommend(result.estimates);
    const Estimate* const outputError = result.find(Estimator::OutputError);
    if (outputError != nullptr && obstacle == nullptr)
        result.holdEvidence = weighHolds(record.force, record.position, outputErrorOptions(record, task),
                                         *outputError, recording.chain.forceLagUncertainty_s);
    result.summedHold = combine(std::array{options.earlierHold, result.holdEvidence});
    result.preparation = record.steps;
    result.time_s = record.time_s;
    result.force = record.force;
    result.position = record.position;
    result.lost = record.lost;
    if (options.assess && obstacle == nullptr)
        result.comparison = comparisonOf(result, record, task);
    result.validity.checks = checkValidity(result, recording, options);
    if (const Estimator better = reconsidered(result); better != result.recommended) {
        result.recommended = better;
        result.validity.checks = checkValidity(result, recording, options);
    }
    judgeBaseline(result);
    result.validity.verdict = overallVerdict(result.validity.checks);
    if (const Estimate* const best = result.best(); best != nullptr && options.assess) {
        result.budget = budgetOf(*best, record, task, result.tellingHold());
        result.validation = validateOnSecondWindow(best->estimator, record, task);
    }
    return result;
}

} // namespace gripscope
