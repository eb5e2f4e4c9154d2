// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/uncertainty/friction_found.h"
#include "core/identification/uncertainty/uncertainty_budget.h"
#include "core/math/least_squares.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace gripscope {

namespace {

using P = MotionParameter;

/// Of the range of the motion: a smaller step is none, and friction keeps the way it had.
constexpr double leastStep = 1e-3;
/// Share of friction's effect that must be its own for the residuals to say anything of it.
constexpr double leastOwnShare = 1e-6;

/// From the first step on, before which nobody knows which side the part came from.
struct RestingColumns {
    Eigen::Index first = 0; ///< the sample that the first row is of
    Eigen::VectorXd effect; ///< -1 after a step up, 1 after one down: what friction of one k does
    Eigen::MatrixXd linear; ///< what offset, compliance and, where there is one, the damping do
};

RestingColumns restingColumns(const std::vector<double>& x, bool damping)
{
    const auto [least, most] = std::ranges::minmax(x);
    const double small = leastStep * (most - least);
    std::size_t first = 1;
    while (first < x.size() && std::abs(x[first] - x[first - 1]) <= small)
        ++first;
    RestingColumns columns;
    columns.first = static_cast<Eigen::Index>(first);
    const auto rows = static_cast<Eigen::Index>(x.size() - std::min(first, x.size()));
    columns.effect = Eigen::VectorXd::Zero(rows);
    columns.linear = Eigen::MatrixXd::Ones(rows, damping ? 3 : 2);
    for (std::size_t i = first; i < x.size(); ++i) {
        const double step = x[i] - x[i - 1];
        const auto at = static_cast<Eigen::Index>(i - first);
        columns.effect(at) = std::abs(step) > small ? -std::copysign(1.0, step) : columns.effect(at - 1);
        columns.linear(at, 1) = x[i] - x[0];
        if (damping)
            columns.linear(at, 2) = x[i - 1] - x[0];
    }
    return columns;
}

/// Of what the residuals hold, in which friction's effect has `own` for itself, and of what is known. Nothing
/// where neither says anything.
std::optional<FrictionFound> frictionOf(const Estimate& estimate, const RestingColumns& columns,
                                        const Eigen::VectorXd& own, double ownShare,
                                        const std::optional<GripperFriction>& known)
{
    if (ownShare <= leastOwnShare)
        return known ? std::optional(FrictionFound{known->value, known->standardError}) : std::nullopt;
    const double k = estimate.motion->values[P::Stiffness];
    const Eigen::Map<const Eigen::VectorXd> residual(estimate.residual.data() + columns.first, own.size());
    const double deviation =
        std::sqrt(estimate.residuals.sse / std::max(estimate.residuals.degreesOfFreedom, 1.0));
    const FrictionFound found{k * residual.dot(own) / own.squaredNorm(), k * deviation / own.norm()};
    return found.deviation > 0 ? together(found, known) : found;
}

/// What friction moves k and b by, that lets the part hang back by `yielded`; `absorbed`: how much of that
/// offset, compliance and damping imitate.
MotionValues shiftBy(double yielded, const Eigen::VectorXd& absorbed, const MotionEstimate& motion,
                     double sampleTime_s)
{
    const double k = motion.values[P::Stiffness];
    const double softer = yielded * absorbed.tail(absorbed.size() - 1).sum();
    MotionValues shift;
    shift[P::Stiffness] = softer * k;
    if (!motion.terms.damping)
        return shift;
    const double b = motion.values[P::Damping];
    const double slower = yielded * absorbed(2); // of exp(-k T / b)
    const double decay = std::exp(-k * sampleTime_s / b);
    shift[P::Damping] = b * (softer + slower * b / (k * sampleTime_s * std::max(decay, 1e-6)));
    return shift;
}

} // namespace

std::optional<RestingFriction> restingFriction(const Estimate& estimate, double sampleTime_s,
                                               const std::optional<GripperFriction>& known)
{
    const std::vector<double>& x = estimate.simulated;
    if (!estimate.motion || estimate.residual.size() != x.size() || x.empty())
        return std::nullopt;
    const MotionEstimate& motion = *estimate.motion;
    MotionTerms terms = motion.terms;
    terms.damping = true;
    if (terms != damperAndSpring)
        return std::nullopt;
    const RestingColumns columns = restingColumns(x, motion.terms.damping);
    const Eigen::VectorXd& effect = columns.effect;
    if (effect.size() < 10)
        return std::nullopt;
    const Eigen::VectorXd absorbed = solvePivoted(columns.linear, effect).solution;
    const Eigen::VectorXd own = effect - columns.linear * absorbed;
    const Eigen::VectorXd about = effect.array() - effect.mean();
    if (!(about.squaredNorm() > 0) || !absorbed.allFinite())
        return std::nullopt;
    RestingFriction found;
    found.ownShare = own.squaredNorm() / about.squaredNorm();
    std::optional<FrictionFound> friction = frictionOf(estimate, columns, own, found.ownShare, known);
    if (!friction || !(friction->deviation > 0))
        return found;
    friction->value = std::max(friction->value, 0.0);
    const double yielded = std::sqrt(secondMoment(*friction)) / motion.values[P::Stiffness];
    found.shift = shiftBy(yielded, absorbed, motion, sampleTime_s);
    return found;
}

} // namespace gripscope
