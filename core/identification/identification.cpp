// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/identification.h"

#include "core/base/parallel_runs.h"
#include "core/base/words.h"
#include "core/base/work_watch.h"
#include "core/identification/comparison/hold_evidence.h"
#include "core/identification/comparison/model_comparison.h"
#include "core/identification/estimators/run_estimator.h"
#include "core/identification/model/identifiability.h"
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

/// A Duffing search takes some microseconds a sample and iteration: a second for this many.
constexpr std::size_t longestCubic = 100'000;

/// The disagreement between windows of the record, each with its own lost samples, by output error or what
/// has the further terms of `whole`. `whole` is the estimate from all of it.
ModelDiscrepancy windowDiscrepancy(const PreparedRecord& record, const EstimatorTask& task,
                                   const Estimate& whole)
{
    EstimatorTask each = task;
    each.freeInitialState = true;
    // Windows of a repeating force need not hold whole periods.
    const bool further = whole.motion || whole.estimator == Estimator::Duffing;
    const Estimator estimator = further ? whole.estimator : Estimator::OutputError;
    return modelDiscrepancy(record.force.size(), record.sampleTime_s, whole, [&](Window window) {
        return runEstimator(estimator, windowOf(record, window), each);
    });
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
    options.discrepancy = windowDiscrepancy(record, task, estimate);
    options.lagBound_s = record.lagBound_s;
    options.positionStep = record.positionStep;
    return uncertaintyBudget(estimate, record.force, record.position, outputErrorOptions(record, task),
                             record.chain, options);
}

bool hasLinear(const Identification& identification)
{
    const Estimate* const linear = identification.find(Estimator::OutputError);
    return linear != nullptr && linear->status == EstimateStatus::Converged;
}

/// A cubic spring: the one that was asked for; else it is tried where there is something to compare it with,
/// no sample is lost and the record is short enough for it to be quick.
std::optional<Estimate> cubicOf(const Identification& identification, const PreparedRecord& record,
                                const EstimatorTask& task)
{
    std::optional<Estimate> cubic;
    if (const Estimate* const found = identification.find(Estimator::Duffing))
        cubic = *found;
    else if (hasLinear(identification) && record.lost.empty() && record.force.size() <= longestCubic)
        cubic = runEstimator(Estimator::Duffing, record, task);
    if (cubic && cubic->status != EstimateStatus::Converged)
        cubic.reset();
    return cubic;
}

/// First-order gain (twice the logarithm of the likelihood) from which on a further term is searched for: a
/// third of what makes a model decisively better.
constexpr double worthSearching = 6;

/// A motion with further terms: the one that was asked for; else it is tried as a cubic spring is.
std::optional<Estimate> motionOf(Estimator estimator, const Identification& identification,
                                 const PreparedRecord& record, const EstimatorTask& task)
{
    std::optional<Estimate> motion;
    if (const Estimate* const found = identification.find(estimator))
        motion = *found;
    else if (hasLinear(identification) && record.lost.empty() && record.force.size() <= longestCubic) {
        const Estimate& linear = *identification.find(Estimator::OutputError);
        MotionOptions options = motionOptions(estimator, record, task);
        options.start = linear.parameters;
        options.startNuisance = linear.nuisance;
        if (expectedGain(record.force, record.position, options) >= worthSearching)
            motion = estimateMotion(record.force, record.position, options);
    }
    if (motion && (motion->status != EstimateStatus::Converged || !motion->parameters))
        motion.reset();
    return motion;
}

/// Twice the gain in the logarithm of the likelihood under white noise, as a first look.
double gainOver(const Estimate& linear, const std::optional<Estimate>& other)
{
    if (!other || !(other->residuals.sse > 0) || !(linear.residuals.sse > 0))
        return 0;
    return static_cast<double>(linear.residual.size()) *
           std::log(linear.residuals.sse / other->residuals.sse);
}

/// What is tried besides output error: each further term alone, side by side, and the two that help most
/// together where each helps much.
struct FurtherTerms {
    std::optional<Estimate> cubic, friction, relaxing, together;

    void findPart(std::int64_t part, const Identification& identification, const PreparedRecord& record,
                  const EstimatorTask& task)
    {
        if (part == 0)
            cubic = cubicOf(identification, record, task);
        else if (part == 1)
            friction = motionOf(Estimator::Friction, identification, record, task);
        else
            relaxing = motionOf(Estimator::Zener, identification, record, task);
    }
    void findTogether(const Identification& identification, const PreparedRecord& record,
                      const EstimatorTask& task)
    {
        const Estimate* const linear = identification.find(Estimator::OutputError);
        if (linear == nullptr)
            return;
        constexpr double much = 2 * decisiveDelta;
        const double byCubic = gainOver(*linear, cubic);
        const double byFriction = gainOver(*linear, friction);
        const double byRelaxing = gainOver(*linear, relaxing);
        const double least = std::min({byCubic, byFriction, byRelaxing});
        if ((byCubic > much) + (byFriction > much) + (byRelaxing > much) < 2)
            return;
        const Estimator both = least == byCubic      ? Estimator::FrictionZener
                               : least == byRelaxing ? Estimator::FrictionDuffing
                                                     : Estimator::ZenerDuffing;
        together = motionOf(both, identification, record, task);
    }
    [[nodiscard]] std::vector<Estimate> motions() const
    {
        std::vector<Estimate> all;
        for (const auto& one : {friction, relaxing, together})
            if (one)
                all.push_back(*one);
        return all;
    }
};

/// Output error of the record against other models. Empty without a converged output-error estimate.
ModelComparison comparisonOf(const Identification& identification, const PreparedRecord& record,
                             const EstimatorTask& task, const Estimate& otherHold,
                             const FurtherTerms& further)
{
    if (!hasLinear(identification))
        return {};
    return compareModels(record.force, record.position, outputErrorOptions(record, task),
                         *identification.find(Estimator::OutputError), otherHold, further.cubic,
                         further.motions());
}

/// The motion with further terms that explains the record decisively better, if one does.
const Estimate* betterMotion(const ModelComparison& comparison)
{
    if (!comparison.decisive || comparison.ranked.empty())
        return nullptr;
    const Estimate& best = comparison.ranked.front().estimate;
    return best.motion ? &best : nullptr;
}

/// "friction of 0.4 N explains this squeeze; without it k would read 4 % high".
void nameFurtherTerms(Identification& data, const QString& forceUnit)
{
    const Estimate* const motion = betterMotion(data.comparison);
    const Estimate* const linear = data.find(Estimator::OutputError);
    if (motion == nullptr || linear == nullptr || !linear->parameters)
        return;
    const double shift = 100 * (linear->parameters->k / motion->parameters->k - 1);
    const MotionValues& values = motion->motion->values;
    const MotionTerms& terms = motion->motion->terms;
    Findings parts;
    if (terms.friction)
        parts.push_back(Words::say("friction of %1 %2")
                            .arg(Finding::number(values[MotionParameter::Friction], 'g', 2))
                            .arg(forceUnit));
    if (terms.relaxation)
        parts.push_back(
            Words::say("a part that goes on yielding by %1 % over %2 s")
                .arg(Finding::number(
                    100 * values[MotionParameter::Relaxing] / values[MotionParameter::Stiffness], 'g', 2))
                .arg(Finding::number(values[MotionParameter::RelaxationTime], 'g', 2)));
    if (terms.cubic)
        parts.push_back(Words::say("a spring that is not straight"));
    const Finding what = parts.size() == 2 ? Words::say("%1 with %2").arg(parts[0], parts[1])
                                           : Finding::joined(parts, QString());
    data.comparison.sentence =
        (shift >= 0 ? Words::say("%1 explains this squeeze; without it k would read %2 % high.")
                    : Words::say("%1 explains this squeeze; without it k would read %2 % low."))
            .arg(what.capitalized())
            .arg(Finding::number(std::abs(shift), 'g', 2));
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
    result.recommended = recommend(result.estimates);
    const Estimate* const outputError = result.find(Estimator::OutputError);
    const bool assessed = options.assess && !obstacle;
    FurtherTerms further;
    Estimate otherHold;
    // Side by side: somebody waits for the verdict.
    shareAmongThreads(4, 0, [&](std::int64_t part) {
        if (part == 3 && outputError != nullptr && !obstacle) {
            const OutputErrorOptions declared = outputErrorOptions(record, task);
            otherHold = estimateOtherHold(record.force, record.position, declared, *outputError);
            result.holdEvidence = weighHolds(record.force, declared, *outputError, otherHold,
                                             recording.chain.forceLagUncertainty_s);
        } else if (part < 3 && assessed) {
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
    if (const Estimate* const best = result.best(); best != nullptr && options.assess)
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
