// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/words.h"
#include "core/identification/model/discretization.h"
#include "core/identification/uncertainty/budget_lines.h"
#include "core/identification/uncertainty/friction_found.h"
#include "core/math/distributions.h"

#include <algorithm>
#include <cmath>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

/// Of the travel: friction may begin to slide over as much (bristles, lubricant, elastic fingertips).
constexpr double largestReach = 0.05;

/// The mean of s(v) over a step in which v goes straight from one value to the other.
double meanSign(double before, double after)
{
    const double size = std::abs(before) + std::abs(after);
    return size > 0 ? (before + after) / size : 0;
}

std::optional<FrictionFound> regress(const LinearizedRecord& record, const std::vector<double>& effect,
                                     const Estimate& estimate)
{
    const EffectTriangle data = effectTriangle(record, std::vector<std::vector<double>>{effect},
                                               estimate.residual, residualColour(estimate, record));
    const Eigen::Index columns = data.triangle.cols() - 1; // friction's is the last of the model
    if (!data.triangle.allFinite() || data.rows <= static_cast<double>(columns))
        return std::nullopt;
    const double own = data.triangle(columns - 1, columns - 1);
    const double rest = std::pow(data.triangle(columns, columns), 2);
    const double deviation = std::sqrt(rest / (data.rows - static_cast<double>(columns))) / std::abs(own);
    const FrictionFound found{data.triangle(columns - 1, columns) / own, deviation};
    return std::isfinite(found.value) && found.deviation > 0 && std::isfinite(found.deviation)
               ? std::optional(found)
               : std::nullopt;
}

/// E a^2 of a normal quantity between 0 and 1.
double secondMomentWithinOne(const FrictionFound& a)
{
    constexpr int steps = 200;
    const double middle = std::clamp(a.value, 0.0, 1.0);
    if (a.deviation < 1.0 / steps)
        return middle * middle;
    double weights = 0;
    double square = 0;
    for (int i = 0; i <= steps; ++i) {
        const double share = static_cast<double>(i) / steps;
        const double distance = (share - middle) / a.deviation;
        const double weight = std::exp(-distance * distance / 2);
        weights += weight;
        square += weight * share * share;
    }
    return square / weights;
}

/// Friction that begins to slide over a reach, against one that slides at once.
struct Presliding {
    std::vector<double> force; ///< by how much less it takes up, a value a sample
    double lostShare = 0;      ///< of the energy that sliding takes from the motion
};
Presliding presliding(const Estimate& estimate, const LinearizedRecord& record, double friction, double reach)
{
    const std::vector<double>& x = estimate.simulated;
    const double stiffness = estimate.parameters->k;
    const double rest = estimate.nuisance.offset.value_or(0);
    double bent = 0; // Bouc and Wen's z, exact along a straight way
    double travel = 0;
    double work = 0;
    Presliding found;
    found.force.resize(x.size());
    for (std::size_t i = 0; i + 1 < x.size(); ++i) {
        const double way = x[i + 1] - x[i];
        const double pull = (record.forceAtSample[i] - stiffness * (x[i] - rest)) / friction;
        const bool sticks = std::abs(way) < 1e-3 * reach;
        const double sign = sticks ? std::clamp(pull, -1.0, 1.0) : std::copysign(1.0, way);
        const double next = sticks ? bent : sign + (bent - sign) * std::exp(-std::abs(way) / reach);
        found.force[i] = friction * (sign - (bent + next) / 2);
        travel += std::abs(way);
        work += way * (bent + next) / 2;
        bent = next;
    }
    found.lostShare = travel > 0 ? std::clamp(1 - work / travel, 0.0, 1.0) : 0;
    return found;
}

} // namespace

std::vector<double> frictionEffect(const Estimate& estimate, const LinearizedRecord& record,
                                   double sampleTime_s)
{
    const std::vector<double>& v = record.velocity;
    std::vector<double> taken(v.size());
    for (std::size_t i = 0; i < v.size(); ++i)
        taken[i] = -meanSign(v[i], v[std::min(i + 1, v.size() - 1)]);
    return simulate(*estimate.parameters, taken, {sampleTime_s, ForceHold::Zero, 0, 0, 0, 0});
}

std::vector<BudgetLine> hiddenFrictionLines(const Estimate& estimate, const LinearizedRecord& record,
                                            const std::vector<double>& effect,
                                            const std::optional<GripperFriction>& known)
{
    if (!record.usable() || estimate.residual.size() != effect.size())
        return {};
    std::optional<FrictionFound> found = regress(record, effect, estimate);
    const Eigen::Matrix3Xd shift = shiftsBy(record, std::vector<std::vector<double>>{effect});
    if (!found || shift.cols() != 1)
        return {};
    found = together(*found, known);
    found->value = std::max(found->value, 0.0);
    const Eigen::Matrix3d relative = secondMoment(*found) * shift.col(0) * shift.col(0).transpose();
    if (!relative.allFinite() || !(relative.trace() > 0))
        return {};
    const auto [least, most] = std::ranges::minmax(record.forceAtSample);
    const double limit = found->value + normalQuantile(0.95) * found->deviation;
    const char* const words =
        known
            ? QT_TRANSLATE_NOOP("Words",
                                "friction of the gripper is known: with what the squeeze tells of it, it is "
                                "up to %1 % of the force's range, and k may be %2 % lower")
            : QT_TRANSLATE_NOOP("Words",
                                "friction of the gripper is not known: up to %1 % of the force's range may "
                                "hide in this squeeze, and k be %2 % lower; more levels of force tell more "
                                "of it");
    return {lineOf(u"friction"_s,
                   Words::say(words)
                       .arg(100 * limit / (most - least), 'g', 2)
                       .arg(100 * std::abs(shift(2, 0)) * limit, 'g', 2),
                   EvaluationType::B, estimate.parameters->vector(), relative)};
}

std::vector<BudgetLine> frictionFormLines(const Estimate& estimate, const LinearizedRecord& record,
                                          double sampleTime_s)
{
    if (!estimate.motion || !estimate.motion->terms.friction || !record.usable() ||
        estimate.simulated.size() != record.velocity.size())
        return {};
    const double friction = estimate.motion->values[MotionParameter::Friction];
    const auto [least, most] = std::ranges::minmax(estimate.simulated);
    const double reach = largestReach * (most - least);
    if (!(friction > 0) || !(reach > 0))
        return {};
    // The friction itself would be found anew with the other form.
    LinearizedRecord withFriction = record;
    const std::vector<double> own = frictionEffect(estimate, record, sampleTime_s);
    withFriction.nuisances.conservativeResize(Eigen::NoChange, record.nuisances.cols() + 1);
    for (std::size_t i = 0; i < record.rows.size(); ++i)
        withFriction.nuisances(static_cast<Eigen::Index>(i), record.nuisances.cols()) =
            own[record.rows[i]] / record.positionScale;
    const Presliding other = presliding(estimate, record, friction, reach);
    const std::vector<double> effect =
        simulate(*estimate.parameters, other.force, {sampleTime_s, ForceHold::Zero, 0, 0, 0, 0});
    const std::optional<FrictionFound> found = regress(withFriction, effect, estimate);
    const Eigen::Matrix3Xd shape = shiftsBy(withFriction, std::vector<std::vector<double>>{effect});
    const Eigen::Matrix3Xd whole = shiftsBy(record, std::vector<std::vector<double>>{own});
    if (!found || shape.cols() != 1 || whole.cols() != 1)
        return {};
    const Eigen::Vector3d size = other.lostShare * friction * whole.col(0);
    const Eigen::Matrix3d relative =
        secondMomentWithinOne(*found) * (shape.col(0) * shape.col(0).transpose() + size * size.transpose());
    if (!relative.allFinite() || !(relative.trace() > 0))
        return {};
    return {
        lineOf(u"friction"_s,
               Words::say("how the friction begins to slide is not known: over %1 % of the travel m would "
                          "be %2 % away, b %3 %")
                   .arg(100 * largestReach, 'g', 2)
                   .arg(100 * std::hypot(shape(0, 0), size(0)), 'g', 2)
                   .arg(100 * std::hypot(shape(1, 0), size(1)), 'g', 2),
               EvaluationType::B, estimate.parameters->vector(), relative)};
}

} // namespace gripscope
