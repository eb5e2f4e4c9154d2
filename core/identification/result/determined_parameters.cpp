// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/result/determined_parameters.h"

#include "core/math/normal_interval.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace gripscope {

namespace {

using P = MotionParameter;
constexpr std::array linearPart{P::Mass, P::Damping, P::Stiffness};

/// value -+ 1.96 errors; friction's is cut at zero.
CoverageInterval noiseInterval(P parameter, double value, double standardError)
{
    const double half = normal95 * standardError;
    CoverageInterval interval{value - half, value + half};
    if (isFriction(parameter) && interval.lower <= 0) {
        interval.lower = 0;
        interval.onlyUpperBound = true;
    }
    return interval;
}

void add(std::vector<DeterminedParameter>& to, P parameter, double value,
         const std::optional<CoverageInterval>& interval)
{
    to.push_back({parameter, value, interval, false, {}});
}

/// In the channels' units.
std::vector<DeterminedParameter> ofEstimate(const Estimate& estimate)
{
    std::vector<DeterminedParameter> found;
    if (estimate.parameters) {
        const Eigen::Vector3d values = estimate.parameters->vector();
        const std::optional<Eigen::Vector3d> errors = estimate.standardErrors();
        for (std::size_t i = 0; i < linearPart.size(); ++i) {
            const auto at = static_cast<Eigen::Index>(i);
            add(found, linearPart[i], values[at],
                errors ? std::optional(noiseInterval(linearPart[i], values[at], (*errors)[at]))
                       : std::nullopt);
        }
    }
    if (estimate.hasAnswer() && estimate.motion) {
        const std::vector<P> parameters = estimate.motion->terms.parameters();
        for (std::size_t i = estimate.parameters ? linearPart.size() : 0; i < parameters.size(); ++i) {
            const double value = estimate.motion->values[parameters[i]];
            const std::optional<double> error = estimate.motion->standardError(parameters[i]);
            add(found, parameters[i], value,
                error ? std::optional(noiseInterval(parameters[i], value, *error)) : std::nullopt);
        }
    }
    if (found.empty() && estimate.stiffnessBounds)
        found.push_back({P::Stiffness, estimate.stiffnessBounds->lower, {}, true, {}});
    return found;
}

std::vector<DeterminedParameter> inComparableUnits(std::vector<DeterminedParameter> found,
                                                   const QString& forceUnit, const QString& positionUnit)
{
    for (DeterminedParameter& one : found) {
        const ComparableUnit to = comparableUnit(one.parameter, forceUnit, positionUnit);
        one.unit = to.unit;
        one.value *= to.factor;
        if (one.interval) {
            one.interval->lower *= to.factor;
            one.interval->upper *= to.factor;
        }
    }
    return found;
}

} // namespace

QString unitOf(MotionParameter parameter, const ParameterUnits& units)
{
    const QString force = units.k.section(u'/', 0, 0);
    const QString position = units.k.section(u'/', 1);
    switch (parameter) {
    case P::Mass:
        return units.m;
    case P::Damping:
    case P::DampingBack:
        return units.b;
    case P::Stiffness:
    case P::Relaxing:
        return units.k;
    case P::RelaxationTime:
        return u"s"_qs;
    case P::Cubic:
        return position.isEmpty() ? u"1"_qs : u"%1/%2^3"_qs.arg(force, position);
    case P::Friction:
    case P::FrictionBack:
    case P::ForceOffset:
        return force;
    }
    return u"1"_qs;
}

bool isRecommended(const Identification& identification, const Estimate& estimate)
{
    return estimate.estimator == identification.recommended && estimate.hasAnswer();
}

ComparableUnit comparableUnit(MotionParameter parameter, const QString& forceUnit,
                              const QString& positionUnit)
{
    const std::optional<double> si = siFactor(forceUnit, positionUnit);
    QString unit = unitOf(parameter, comparableUnits(forceUnit, positionUnit));
    switch (parameter) {
    case P::RelaxationTime:
        return {unit};
    case P::Cubic:
        return {cubicStiffnessUnit(forceUnit, positionUnit),
                cubicSiFactor(forceUnit, positionUnit).value_or(1)};
    case P::Friction:
    case P::FrictionBack:
    case P::ForceOffset:
        return {unit, si ? newtonsPer(forceUnit).value_or(1) : 1};
    default:
        return {unit, si.value_or(1)};
    }
}

std::vector<DeterminedParameter> determinedParameters(const Estimate& estimate, const QString& forceUnit,
                                                      const QString& positionUnit)
{
    return inComparableUnits(ofEstimate(estimate), forceUnit, positionUnit);
}

std::vector<DeterminedParameter> determinedParameters(const Identification& identification,
                                                      const QString& forceUnit, const QString& positionUnit)
{
    const UncertaintyBudget& budget = identification.budget;
    std::vector<DeterminedParameter> found;
    if (budget.parameters) {
        const Eigen::Vector3d values = budget.parameters->vector();
        for (std::size_t i = 0; i < linearPart.size(); ++i)
            add(found, linearPart[i], values[static_cast<Eigen::Index>(i)], budget.intervals[i]);
    }
    for (const FurtherParameter& further : budget.further)
        add(found, further.parameter, further.value, further.interval);
    const Estimate* const recommended = identification.find(identification.recommended);
    if (found.empty() && recommended != nullptr)
        found = ofEstimate(*recommended);
    return inComparableUnits(std::move(found), forceUnit, positionUnit);
}

} // namespace gripscope
