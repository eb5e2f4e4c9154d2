// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/identification.h"

#include "core/base/parallel_runs.h"
#include "core/base/words.h"
#include "core/base/work_watch.h"
#include "core/identification/comparison/hold_evidence.h"
#include "core/identification/comparison/model_comparison.h"
#include "core/identification/estimators/run_estimator.h"
#include "core/identification/further_terms.h"
#include "core/identification/model/identifiability.h"
#include "core/identification/motion/motion.h"
#include "core/identification/output_error/output_error.h"
#include "core/identification/uncertainty/uncertainty_budget.h"
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

/// For a motion without a mass or a spring, whose swings and time constants say nothing of how long a part
/// must be.
std::vector<Window> evenWindows(std::size_t samples)
{
    constexpr std::size_t windows = 5;
    constexpr std::size_t fewest = 60;
    std::vector<Window> out;
    for (std::size_t i = 0; i < windows && samples >= windows * fewest; ++i)
        out.push_back({i * (samples / windows), samples / windows});
    return out;
}

/// The disagreement between windows of the record, each with its own lost samples, by output error or what
/// has the further terms of `whole`. `whole` is the estimate from all of it; `motions`: those found in
/// windows.
ModelDiscrepancy windowDiscrepancy(const PreparedRecord& record, const EstimatorTask& task,
                                   const Estimate& whole, std::vector<MotionEstimate>& motions)
{
    EstimatorTask each = task;
    each.freeInitialState = true;
    each.residuals = ResidualDepth::Noise;
    // Windows of a repeating force need not hold whole periods.
    const Estimator estimator = whole.motion ? whole.estimator : Estimator::OutputError;
    const auto estimateWindow = [&](Window window) {
        Estimate part = runEstimator(estimator, windowOf(record, window), each);
        if (part.motion)
            motions.push_back(*part.motion);
        return part;
    };
    if (whole.isPartialMotion()) // no mass or no spring: what there is is compared one by one
        for (const Window& window : evenWindows(record.force.size()))
            estimateWindow(window);
    return modelDiscrepancy(record.force.size(), record.sampleTime_s, whole, estimateWindow);
}

/// A carriage whose damping and friction differ with the way it moves; nothing for other motions.
std::optional<MotionEstimate> eachWay(const Estimate& estimate, const PreparedRecord& record,
                                      const EstimatorTask& task)
{
    if (!estimate.motion || estimate.motion->terms.spring || !estimate.motion->terms.friction)
        return std::nullopt;
    MotionOptions options = motionOptions(estimate.estimator, record, task);
    options.terms.eachWay = true;
    options.terms.forceOffset = false; // it is friction that differs, then
    return estimateMotion(record.force, record.position, options).motion;
}

/// The budget of `estimate`: its noise, the counts, the chain's effects, the other hold as far as `holds`
/// leaves it probable, and what the windows disagree by. Without parameters and covariance: a budget that
/// says why there is none.
UncertaintyBudget budgetOf(const Estimate& estimate, const PreparedRecord& record, const EstimatorTask& task,
                           const HoldEvidence& holds)
{
    BudgetOptions options;
    if (holds.parameters && holds.otherParameters && estimate.parameters) {
        // As far from this estimate as output error moves with the hold, whichever estimator this is.
        const Eigen::Vector3d ratio =
            holds.otherParameters->vector().cwiseQuotient(holds.parameters->vector());
        const Eigen::Vector3d other = estimate.parameters->vector().cwiseProduct(ratio);
        options.hold = HoldAmbiguity{{other(0), other(1), other(2)}, holds.otherProbability()};
    }
    std::vector<MotionEstimate> motions;
    options.discrepancy = windowDiscrepancy(record, task, estimate, motions);
    options.lagBound_s = record.lagBound_s;
    options.positionStep = record.positionStep;
    options.frictionIsKnown = estimate.motion && estimate.motion->terms.friction;
    UncertaintyBudget budget = uncertaintyBudget(estimate, record.force, record.position,
                                                 outputErrorOptions(record, task), record.chain, options);
    if (estimate.motion)
        budget.further = furtherParameters(*estimate.motion, record.chain, motions,
                                           eachWay(estimate, record, task), budget.coverage);
    if (!budget.parameters && !budget.further.empty())
        budget.message = {};
    return budget;
}

/// Of a stiffness between bounds; else why there is none.
UncertaintyBudget heldBudget(const Estimate& estimate, const PreparedRecord& record)
{
    UncertaintyBudget budget;
    budget.message = estimate.message;
    if (estimate.stiffnessBounds && estimate.stiffnessBounds->upper)
        budget.further = {boundedStiffness(estimate.stiffnessBounds->lower, *estimate.stiffnessBounds->upper,
                                           record.chain, budget.coverage)};
    return budget;
}

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
    return cubicIsBetter(data) ? Estimator::Duffing : data.recommended;
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
    result.validity.checks = checkValidity(result, recording, options);
    if (const Estimator better = reconsidered(result); better != result.recommended) {
        result.recommended = better;
        result.validity.checks = checkValidity(result, recording, options);
    }
    judgeBaseline(result);
    result.validity.verdict = overallVerdict(result.validity.checks);
    const Estimate* const best = result.find(result.recommended);
    if (record.held && options.assess)
        result.budget = heldBudget(*best, record);
    else if (best != nullptr && best->hasAnswer() && options.assess)
        shareAmongThreads(2, 0, [&](std::int64_t part) {
            if (part == 0)
                result.budget = budgetOf(*best, record, task, result.tellingHold());
            else
                result.validation = validateOnSecondWindow(best->estimator, record, task);
        });
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
