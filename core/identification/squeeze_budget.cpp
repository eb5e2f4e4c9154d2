// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/identification_steps.h"
#include "core/identification/model/evidence.h"
#include "core/identification/motion/motion.h"
#include "core/identification/uncertainty/uncertainty_budget.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

namespace gripscope {

namespace {

/// Of any window.
constexpr std::size_t fewestInWindow = 60;

/// For a motion without a mass or a spring, whose swings and time constants say nothing of how long a part
/// must be.
std::vector<Window> evenWindows(std::size_t samples)
{
    constexpr std::size_t windows = 5;
    std::vector<Window> out;
    for (std::size_t i = 0; i < windows && samples >= windows * fewestInWindow; ++i)
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
    each.near = &whole;
    // Windows of a repeating force need not hold whole periods.
    const Estimator estimator = whole.motion ? whole.estimator : Estimator::OutputError;
    // Windows side by side, equally long: each has its own place.
    std::vector<std::optional<MotionEstimate>> found(record.force.size() / fewestInWindow);
    const auto estimateWindow = [&](Window window) {
        Estimate part = runEstimator(estimator, windowOf(record, window), each);
        found[window.first / window.count] = part.motion;
        return part;
    };
    if (whole.isPartialMotion()) // no mass or no spring: what there is is compared one by one
        for (const Window& window : evenWindows(record.force.size()))
            estimateWindow(window);
    ModelDiscrepancy discrepancy =
        modelDiscrepancy(record.force.size(), record.sampleTime_s, whole, estimateWindow);
    for (const std::optional<MotionEstimate>& motion : found)
        if (motion)
            motions.push_back(*motion);
    return discrepancy;
}

/// A carriage whose damping and friction differ with the way it moves.
std::optional<MotionEstimate> eachWay(const Estimate& estimate, const PreparedRecord& record,
                                      const EstimatorTask& task)
{
    MotionOptions options = motionOptions(estimate.estimator, record, task);
    options.terms.eachWay = true;
    options.terms.forceOffset = false; // it is friction that differs, then
    return estimateMotion(record.force, record.position, options).motion;
}

/// The motion that has the mass which was left out, as far as it was found.
std::optional<MotionEstimate> withMass(const Identification& data, Estimator estimator)
{
    for (const Estimate& other : data.estimates)
        if (withoutMass(other.estimator) == estimator && other.status == EstimateStatus::Converged)
            return motionOf(other);
    return std::nullopt;
}

std::optional<MotionEstimate> otherForm(const Identification& data, const Estimate& estimate,
                                        const PreparedRecord& record, const EstimatorTask& task)
{
    const MotionTerms& terms = estimate.motion->terms;
    if (!terms.mass)
        return withMass(data, estimate.estimator);
    return !terms.spring && terms.friction ? eachWay(estimate, record, task) : std::nullopt;
}

/// Lets `far` reach as far as the parameters of `other` are from those of `estimate`.
void stretch(MotionValues& far, const Estimate& other, const Estimate& estimate)
{
    for (std::size_t i = 0; i < far.values.size(); ++i) {
        const double away = other.motion->values.values[i] - estimate.motion->values.values[i];
        far.values[i] = std::max(far.values[i], std::abs(away));
    }
}

/// What the lag between the channels and a hold that nobody declared move a motion without mass by, found by
/// estimating it with them changed: as far as that does not explain the squeeze decisively worse. (With a
/// mass the budget's own lines have them; on an axis without a spring both are small beside what its friction
/// does.)
class AssumptionShifts {
public:
    AssumptionShifts(const Estimate& estimate, const PreparedRecord& record, const EstimatorTask& task)
        : m_estimate(estimate), m_record(record), m_task(task)
    {
    }

    /// Of one standard deviation of the lag, either way, or of as much of it as is not refuted.
    [[nodiscard]] MotionValues ofLag(double lag_s) const
    {
        constexpr double leastShare = 1.0 / 64;
        MotionValues far;
        for (const double way : {-1.0, 1.0})
            for (double share = 1; share >= leastShare; share /= 2)
                if (const auto other = found(m_task.hold, way * share * lag_s)) {
                    stretch(far, *other, m_estimate);
                    break;
                }
        return far;
    }
    /// Of the other hold: either, and all between them alike.
    [[nodiscard]] MotionValues ofHold() const
    {
        MotionValues far;
        const bool isZero = m_task.hold == ForceHold::Zero;
        if (const auto other = found(isZero ? ForceHold::First : ForceHold::Zero, 0))
            stretch(far, *other, m_estimate);
        for (double& value : far.values)
            value /= std::numbers::sqrt3;
        return far;
    }

private:
    [[nodiscard]] std::optional<Estimate> found(ForceHold hold, double lag_s) const
    {
        MotionOptions options = motionOptions(m_estimate.estimator, m_record, m_task);
        options.hold = hold;
        options.lag_s += lag_s;
        Estimate other = estimateMotion(m_record.force, m_record.position, options);
        const bool counts =
            other.motion && other.hasAnswer() && !isDecisivelyWorse(other, m_estimate, m_record.positionStep);
        return counts ? std::optional(std::move(other)) : std::nullopt;
    }

    const Estimate& m_estimate;
    const PreparedRecord& m_record;
    const EstimatorTask& m_task;
};

/// Of a motion without mass: of the assumptions, and of what it leaves out, a mass and friction.
std::vector<MotionValues> shiftsOf(const Estimate& estimate, const PreparedRecord& record,
                                   const EstimatorTask& task, bool holdIsDeclared)
{
    std::vector<MotionValues> shifts;
    if (estimate.motion->terms.mass)
        return shifts;
    const AssumptionShifts under(estimate, record, task);
    const double measured = record.chain.forceLagUncertainty_s;
    const double lag_s = measured > 0 ? measured : record.lagBound_s / std::numbers::sqrt3;
    if (lag_s > 0)
        shifts.push_back(under.ofLag(lag_s));
    if (!holdIsDeclared)
        shifts.push_back(under.ofHold());
    if (const auto mass =
            hiddenMassShift(estimate, record.force, record.position, outputErrorOptions(record, task)))
        shifts.insert(shifts.end(), 2, *mass); // counted once, upper bounds of b were found that do not hold
    if (const auto friction = restingFriction(estimate, record.sampleTime_s, record.chain.friction))
        shifts.push_back(friction->shift);
    return shifts;
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

/// As far from this estimate as output error moves with the hold, whichever estimator this is.
std::optional<HoldAmbiguity> holdAmbiguity(const HoldEvidence& holds, const Estimate& estimate)
{
    if (!holds.parameters || !holds.otherParameters || !estimate.parameters)
        return std::nullopt;
    const Eigen::Vector3d ratio = holds.otherParameters->vector().cwiseQuotient(holds.parameters->vector());
    const Eigen::Vector3d other = estimate.parameters->vector().cwiseProduct(ratio);
    return HoldAmbiguity{{other(0), other(1), other(2)}, holds.otherProbability()};
}

} // namespace

UncertaintyBudget squeezeBudget(const Identification& data, const PreparedRecord& record,
                                const EstimatorTask& task, bool holdIsDeclared)
{
    const Estimate& estimate = *data.find(data.recommended);
    if (record.held)
        return heldBudget(estimate, record);
    BudgetOptions options;
    options.hold = holdAmbiguity(data.tellingHold(), estimate);
    MotionDoubts doubts;
    options.discrepancy = windowDiscrepancy(record, task, estimate, doubts.parts);
    options.lagBound_s = record.lagBound_s;
    options.positionStep = record.positionStep;
    options.frictionIsKnown = estimate.motion && estimate.motion->terms.friction;
    UncertaintyBudget budget = uncertaintyBudget(estimate, record.force, record.position,
                                                 outputErrorOptions(record, task), record.chain, options);
    if (estimate.motion) {
        doubts.otherForm = otherForm(data, estimate, record, task);
        doubts.shifts = shiftsOf(estimate, record, task, holdIsDeclared);
        doubts.roundingVariances = roundingVariances(estimate, record.positionStep);
        budget.further = furtherParameters(*estimate.motion, record.chain, doubts, budget.coverage);
    }
    if (!budget.parameters && !budget.further.empty())
        budget.message = {};
    return budget;
}

} // namespace gripscope
