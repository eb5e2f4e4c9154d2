// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/uncertainty/budget_lines.h"
#include "core/identification/uncertainty/uncertainty_budget.h"
#include "core/math/distributions.h"
#include "core/math/robust_statistics.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gripscope {

namespace {

using P = MotionParameter;

/// The power in which a scale error of the force, and of the position, moves a parameter.
struct ScalePowers {
    double force = 0, position = 0;
};

ScalePowers powersOf(P parameter)
{
    switch (parameter) {
    case P::RelaxationTime:
        return {0, 0};
    case P::Friction:
    case P::FrictionBack:
    case P::ForceOffset:
        return {1, 0};
    case P::Cubic:
        return {1, -3};
    default:
        return {1, -1};
    }
}

/// The variance from one part of the record to the next beyond what the parts' own errors explain, where
/// their agreement is refuted (as discrepancyBetween(), for one parameter).
struct BetweenParts {
    double variance = 0;
    std::optional<double> degreesOfFreedom;
};

BetweenParts betweenParts(const MotionEstimate& whole, std::size_t index,
                          std::span<const MotionEstimate> parts)
{
    const auto at = static_cast<Eigen::Index>(index);
    std::vector<ValueWithError> found;
    for (const MotionEstimate& part : parts) {
        const double variance = part.terms == whole.terms ? part.covariance(at, at) : 0;
        if (variance > 0 && std::isfinite(variance))
            found.push_back({part.values[whole.terms.parameters()[index]], std::sqrt(variance)});
    }
    constexpr std::size_t fewest = 3;
    if (found.size() < fewest)
        return {};
    const auto count = static_cast<double>(found.size());
    double mean = 0;
    double weighted = 0;
    double weights = 0;
    for (const ValueWithError& one : found) {
        const double weight = 1 / (one.standardError * one.standardError);
        mean += one.value / count;
        weighted += one.value * weight;
        weights += weight;
    }
    double q = 0;
    double excess = 0;
    for (const ValueWithError& one : found) {
        q += std::pow((one.value - weighted / weights) / one.standardError, 2);
        excess += std::pow(one.value - mean, 2) / (count - 1) - std::pow(one.standardError, 2) / count;
    }
    if (chiSquaredAbove(q, count - 1) > discrepancyLevel)
        return {};
    return {std::max(excess, 0.0), count - 1};
}

/// How far the parameter is from what it would be in the other form; 0 where that does not have it.
double awayFrom(const std::optional<MotionEstimate>& otherForm, P parameter, double value)
{
    if (!otherForm || std::ranges::count(otherForm->terms.parameters(), parameter) == 0)
        return 0;
    double other = otherForm->values[parameter];
    if (parameter == P::Damping && otherForm->terms.eachWay)
        other = (other + otherForm->values[P::DampingBack]) / 2;
    else if (parameter == P::Friction && otherForm->terms.eachWay)
        other = (other + otherForm->values[P::FrictionBack]) / 2;
    return std::isfinite(other) ? value - other : 0;
}

/// The variance that the doubts but the parts add to one of the motion's parameters.
double varianceOf(const MotionDoubts& doubts, const MotionEstimate& motion, P parameter, Eigen::Index at)
{
    double variance = std::pow(awayFrom(doubts.otherForm, parameter, motion.values[parameter]), 2);
    for (const MotionValues& shift : doubts.shifts)
        variance += std::pow(shift[parameter], 2);
    return at < doubts.roundingVariances.size() ? variance + doubts.roundingVariances(at) : variance;
}

} // namespace

FurtherParameter boundedStiffness(double lower, double upper, const MeasuringChain& chain, double coverage)
{
    FurtherParameter k;
    k.parameter = P::Stiffness;
    k.value = std::sqrt(lower) * std::sqrt(upper);
    const double scale = std::hypot(chain.forceScaleUncertainty, chain.positionScaleUncertainty);
    const double half = (std::log(upper) - std::log(lower)) / 2;
    const double relative = std::hypot(half / std::numbers::sqrt3, scale);
    // Student's factor of the scales alone, on top of all that is possible.
    const double reach = half + coverageFactor(coverage, std::nullopt) * scale;
    k.combined.standardUncertainty = relative * k.value;
    k.combined.coverageFactor = relative > 0 ? reach / relative : 0;
    k.interval = {k.value * std::exp(-reach), k.value * std::exp(reach), true};
    return k;
}

std::vector<FurtherParameter> furtherParameters(const MotionEstimate& motion, const MeasuringChain& chain,
                                                const MotionDoubts& doubts, double coverage)
{
    std::vector<FurtherParameter> out;
    const std::vector<P> parameters = motion.terms.parameters();
    const bool linearPartElsewhere = motion.terms.mass && motion.terms.spring;
    for (std::size_t i = 0; i < parameters.size(); ++i) {
        const auto at = static_cast<Eigen::Index>(i);
        if (linearPartElsewhere && i < 3)
            continue;
        FurtherParameter further;
        further.parameter = parameters[i];
        further.value = motion.values[parameters[i]];
        double ownVariance = 0;
        if (const auto linear = linearPlaceOf(parameters[i]); linear && chain.baseline) {
            further.value -= chain.baseline->parameters[*linear];
            ownVariance = std::pow(chain.baseline->standardErrors[*linear], 2);
            if (!(further.value > 0))
                continue; // not told from the empty gripper
        }
        if (parameters[i] == P::Friction && chain.friction && motion.terms.spring) {
            further.value = std::max(0.0, further.value - chain.friction->value);
            ownVariance = std::pow(chain.friction->standardError, 2);
        }
        const ScalePowers powers = powersOf(parameters[i]);
        const double scale = further.value * std::hypot(powers.force * chain.forceScaleUncertainty,
                                                        powers.position * chain.positionScaleUncertainty);
        const double k = motion.values[P::Stiffness];
        const double byFrame = parameters[i] == P::Stiffness ? k * k * chain.frameComplianceUncertainty : 0.0;
        const BetweenParts between = betweenParts(motion, i, doubts.parts);
        const double variance = motion.covariance(at, at) + ownVariance + scale * scale + byFrame * byFrame +
                                between.variance + varianceOf(doubts, motion, parameters[i], at);
        if (!std::isfinite(variance) || variance < 0)
            continue;
        CombinedUncertainty& u = further.combined;
        u.standardUncertainty = std::sqrt(variance);
        if (between.variance > 0 && between.degreesOfFreedom)
            u.degreesOfFreedom =
                std::max(*between.degreesOfFreedom * std::pow(variance / between.variance, 2), 1.0);
        u.coverageFactor = coverageFactor(coverage, u.degreesOfFreedom);
        further.interval = intervalAround(further.value, u, isPositive(parameters[i]),
                                          !isPositive(parameters[i]) && !isFriction(parameters[i]));
        out.push_back(further);
    }
    return out;
}

} // namespace gripscope
