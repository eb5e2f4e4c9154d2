// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/words.h"
#include "core/identification/identification_steps.h"
#include "core/identification/model/evidence.h"
#include "core/identification/uncertainty/uncertainty_budget.h"

#include <algorithm>
#include <cmath>

namespace gripscope {

namespace {

/// Relative standard error below which nobody has to ask what the motion would be without a mass.
constexpr double wellKnown = 0.02;

/// The motion whose mass is in question: the recommended one, or output error where it found nothing.
const Estimate* motionInQuestion(const Identification& data)
{
    const Estimate* const recommended = data.find(data.recommended);
    if (recommended != nullptr && withoutMass(recommended->estimator) && recommended->hasAnswer())
        return recommended;
    const Estimate* const linear = data.find(Estimator::OutputError);
    return linear != nullptr && linear->status == EstimateStatus::NotIdentifiable ? linear : nullptr;
}

/// Where output error found nothing, for whatever reason: without a mass it is explained, by levels of force
/// that tell its stiffness from friction. A lone step does not.
bool isPlain(const Estimate& whole, const Estimate& without, const PreparedRecord& record)
{
    constexpr double leastFitPercent = 50;
    if (whole.parameters || whole.notFromZero == MotionParameter::Mass)
        return true;
    const auto friction = restingFriction(without, record.sampleTime_s, record.chain.friction);
    return without.fit.simulationPercent.value_or(0) >= leastFitPercent && friction && friction->isTold();
}

bool isWellKnown(const Estimate& whole, double positionStep)
{
    const std::optional<Eigen::Vector3d> errors = whole.standardErrors();
    if (!whole.parameters || !errors)
        return false;
    // Counts without noise leave residuals that say less of the errors than their steps do.
    const double variance = whole.residuals.sse / std::max(whole.residuals.degreesOfFreedom, 1.0);
    const double least = positionStep * positionStep / 12;
    const double wider = variance > 0 && variance < least ? std::sqrt(least / variance) : 1.0;
    return wider * (*errors)(0) <= wellKnown * whole.parameters->m;
}

} // namespace

std::optional<Estimator> withoutMass(Estimator estimator)
{
    switch (estimator) {
    case Estimator::OutputError:
        return Estimator::Static;
    case Estimator::Zener:
        return Estimator::StaticZener;
    case Estimator::Duffing:
        return Estimator::StaticDuffing;
    default:
        return std::nullopt;
    }
}

void leaveOutUntoldMass(Identification& data, const PreparedRecord& record, const EstimatorTask& task)
{
    const Estimate* const whole = motionInQuestion(data);
    if (whole == nullptr || isWellKnown(*whole, record.positionStep))
        return;
    const Estimator estimator = *withoutMass(whole->estimator);
    const Estimate* const asked = data.find(estimator);
    const Estimate without = asked != nullptr ? *asked : runEstimator(estimator, record, task);
    if (!without.hasAnswer() || !isPlain(*whole, without, record) ||
        (whole->parameters && isDecisivelyWorse(without, *whole, record.positionStep)))
        return;
    if (asked == nullptr)
        data.estimates.push_back(without);
    data.recommended = estimator;
    data.comparison.sentence =
        Words::say("These samples do not tell a mass: the motion without it explains the squeeze as well.");
}

} // namespace gripscope
