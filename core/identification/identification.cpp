// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/identification.h"

#include "core/base/parallel_runs.h"
#include "core/base/words.h"
#include "core/base/work_watch.h"
#include "core/identification/comparison/hold_evidence.h"
#include "core/identification/comparison/model_comparison.h"
#include "core/identification/estimators/run_estimator.h"
#include "core/identification/identification_steps.h"
#include "core/identification/model/identifiability.h"
#include "core/identification/output_error/output_error.h"
#include "core/identification/validation/validation.h"
#include "core/identification/validity/validity_checks.h"
#include "core/math/fit.h"
#include "core/math/robust_statistics.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace gripscope {

namespace {

/// What keeps every estimator from starting, or nothing.
std::optional<Finding> unusable(const PreparedRecord& record)
{
    if (record.force.size() != record.position.size())
        return Words::say("force and position have different lengths");
    if (!std::isfinite(record.sampleTime_s) || !(record.sampleTime_s > 0) ||
        !std::isfinite(record.forceLag_s))
        return Words::say("the sample time or the lag is not a usable number");
    if (!allFinite(record.force) || !allFinite(record.position))
        return Words::say("the recording holds values that are not finite");
    return std::nullopt;
}

/// Output error where it converged; else the estimate that simulates best.
Estimator recommend(const std::vector<Estimate>& estimates)
{
    const Estimate* best = nullptr;
    for (const Estimate& estimate : estimates) {
        if (!estimate.hasAnswer())
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

bool checkFailed(const std::vector<ValidityCheck>& checks, const QString& id)
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
        checkFailed(data.validity.checks, QStringLiteral("feedback")))
        return Estimator::Periodic;
    const bool isLinear = data.recommended == Estimator::OutputError;
    return isLinear && cubicIsBetter(data) ? Estimator::Duffing : data.recommended;
}

/// A motion that explains the squeeze decisively better is the one to believe, asked for or not.
void takeBetterMotion(Identification& data)
{
    const Estimate* const motion = betterMotion(data.comparison);
    if (motion == nullptr || data.recommended != Estimator::OutputError)
        return;
    if (data.find(motion->estimator) == nullptr)
        data.estimates.push_back(*motion);
    data.recommended = motion->estimator;
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
        check.message = Words::say(
            "the squeeze is not told from the empty gripper: with its m, b and k taken off, not all that is "
            "left is above zero. Check that the part was between the fingers, and measure the empty gripper "
            "again");
    }
}

/// What only the budget needed.
void dropInfluences(Identification& data)
{
    const auto drop = [](Estimate& estimate) {
        if (estimate.motion)
            estimate.motion->influences = {};
    };
    std::ranges::for_each(data.estimates, drop);
    std::ranges::for_each(data.comparison.ranked, drop, &ComparedModel::estimate);
}

Eigen::Vector3d standardErrors(const UncertaintyBudget& budget, EvaluationType type)
{
    Eigen::Vector3d variances = Eigen::Vector3d::Zero();
    for (const BudgetLine& line : budget.lines)
        if (line.type == type)
            variances += line.covariance.diagonal();
    return variances.cwiseMax(0).cwiseSqrt();
}

bool isUsable(const UncertaintyBudget& budget)
{
    return budget.parameters && budget.parameters->vector().allFinite() &&
           budget.parameters->vector().minCoeff() > 0 && budget.covariance.allFinite();
}

/// A floor keeps a squeeze without noise from outweighing all others without end.
double withFloor(double error, double value)
{
    constexpr double leastRelativeError = 1e-9;
    return std::max(error, leastRelativeError * value);
}

} // namespace

HoldEvidence holdDeclaration(const Recording& recording, const IdentificationOptions& options)
{
    HoldEvidence declaration;
    declaration.declared = options.hold.value_or(recording.hold.value_or(ForceHold::First));
    declaration.lag_s = recording.forceLag_s;
    declaration.lagUncertainty_s = recording.chain.forceLagUncertainty_s;
    return declaration;
}

namespace {
/// Of the work of an identification by every estimator: the rest is what assesses the result.
constexpr double shareOfEstimators = 0.7;
} // namespace

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

    const std::optional<Finding> obstacle = unusable(record);
    for (const Estimator estimator : options.estimators) {
        if (isStopped(options.watch))
            return result;
        result.estimates.push_back(
            obstacle ? statusOnly(estimator, EstimateStatus::NotApplicable, *obstacle)
                     : runEstimator(estimator, record, task,
                                    estimator == Estimator::Periodic ? &result.repetition : nullptr));
        if (options.watch)
            options.watch->setShare(shareOfEstimators * static_cast<double>(result.estimates.size()) /
                                    static_cast<double>(options.estimators.size()));
    }
    if (isStopped(options.watch))
        return result;
    if (record.held && result.find(Estimator::Static) == nullptr)
        result.estimates.push_back(runEstimator(Estimator::Static, record, task));
    result.recommended = record.held ? Estimator::Static : recommend(result.estimates);
    const Estimate* const outputError = result.find(Estimator::OutputError);
    const bool assessed = options.assess && !obstacle && !record.held;
    FurtherTerms further;
    Estimate otherHold;
    // Side by side: somebody waits for the verdict.
    shareAmongThreads(FurtherTerms::parts + 1, 0, [&](std::int64_t part) {
        if (part == FurtherTerms::parts && outputError != nullptr && !obstacle && !record.held) {
            const OutputErrorOptions declared = outputErrorOptions(record, task);
            otherHold = estimateOtherHold(record.force, record.position, declared, *outputError);
            result.holdEvidence = weighHolds(record.force, declared, *outputError, otherHold,
                                             recording.chain.forceLagUncertainty_s);
        } else if (part < FurtherTerms::parts && assessed) {
            further.findPart(part, result, record, task);
        }
    });
    if (assessed)
        further.findTogether(result, record, task);
    result.summedHold = combine(std::array{options.earlierHold, result.holdEvidence});
    result.preparation = record.steps;
    result.time_s = record.time_s;
    result.force = record.force;
    result.position = record.position;
    result.lost = record.lost;
    if (assessed)
        result.comparison = comparisonOf(result, record, task, otherHold, further);
    nameFurtherTerms(result, recording.forceUnit);
    takeBetterMotion(result);
    if (assessed)
        leaveOutUntoldMass(result, record, task);
    result.validity.checks = checkValidity(result, recording, options);
    if (const Estimator better = reconsidered(result); better != result.recommended) {
        result.recommended = better;
        result.validity.checks = checkValidity(result, recording, options);
    }
    judgeBaseline(result);
    result.validity.verdict = overallVerdict(result.validity.checks);
    const Estimate* const best = result.find(result.recommended);
    const bool hasAnswer = best != nullptr && best->hasAnswer();
    if (options.assess && (record.held || hasAnswer))
        shareAmongThreads(2, 0, [&](std::int64_t part) {
            if (part == 0)
                result.budget = squeezeBudget(result, record, task, options.hold || recording.hold);
            else if (!record.held) {
                EstimatorTask near = task;
                near.near = best;
                result.validation = validateOnSecondWindow(best->estimator, record, near);
            }
        });
    dropInfluences(result);
    return result;
}

double RepeatedMeasurement::standardUncertainty(std::size_t parameter) const
{
    return std::hypot(ownErrors[parameter], sharedErrors[parameter]);
}

std::optional<RepeatedMeasurement> repeatedMeasurement(std::span<const Identification> squeezes)
{
    const auto usable = [](const Identification& squeeze) { return isUsable(squeeze.budget); };
    if (squeezes.empty() || !std::all_of(squeezes.begin(), squeezes.end(), usable))
        return std::nullopt;
    RepeatedMeasurement found;
    const std::array<double*, 3> values{&found.parameters.m, &found.parameters.b, &found.parameters.k};
    for (std::size_t i = 0; i < values.size(); ++i) {
        const auto index = static_cast<Eigen::Index>(i);
        std::vector<ValueWithError> measured;
        for (const Identification& squeeze : squeezes) {
            const double value = squeeze.budget.parameters->vector()(index);
            const double own = standardErrors(squeeze.budget, EvaluationType::A)(index);
            const double shared = standardErrors(squeeze.budget, EvaluationType::B)(index);
            measured.push_back({value, withFloor(own, value)});
            found.sharedErrors[i] = std::max(found.sharedErrors[i], shared);
        }
        const ValueWithError mean = pooledMean(measured);
        *values[i] = mean.value;
        found.ownErrors[i] = mean.standardError;
    }
    return found;
}

} // namespace gripscope
