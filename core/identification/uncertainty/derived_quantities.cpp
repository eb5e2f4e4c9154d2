// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/uncertainty/derived_quantities.h"

#include "core/base/words.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

constexpr double undeterminedShare = 0.5;
constexpr double twoPi = 2 * std::numbers::pi;

/// A positive quantity and its logarithmic derivatives to (ln m, ln b, ln k).
struct Logarithmic {
    double value;
    Eigen::Vector3d derivatives;
};

Finding digits(double value)
{
    return Finding::number(value, 'g', 2);
}

DerivedQuantity quantity(const UncertaintyBudget& budget, const QString& id, const Finding& name,
                         const QString& unit, const Logarithmic& q)
{
    DerivedQuantity out;
    out.id = id;
    out.name = name;
    out.unit = unit;
    // Relative uncertainty first: the value itself may be of any size.
    const Eigen::Vector3d gradient = q.derivatives.cwiseQuotient(budget.parameters->vector());
    out.uncertainty = budget.propagate(gradient);
    const double relative = out.uncertainty.standardUncertainty;
    const double exponent = std::min(out.uncertainty.coverageFactor * relative, 50.0);
    out.uncertainty.standardUncertainty = std::min(relative * q.value, std::numeric_limits<double>::max());
    out.interval.logarithmic = true;
    out.interval.lower = q.value * std::exp(-exponent);
    out.interval.upper = std::min(q.value * std::exp(exponent), std::numeric_limits<double>::max());
    if (relative <= undeterminedShare)
        out.value = q.value;
    else
        out.words =
            Words::say("this record does not determine the %1: its standard uncertainty is %2 % of its value")
                .arg(name, digits(100 * relative));
    return out;
}

/// Where m is known from above alone, the natural frequency is known from below.
void boundFrequency(const UncertaintyBudget& budget, DerivedQuantity& frequency)
{
    if (!budget.intervals[0].onlyUpperBound || budget.intervals[2].onlyUpperBound)
        return;
    const double least = std::sqrt(budget.intervals[2].lower) / std::sqrt(budget.intervals[0].upper) / twoPi;
    if (!std::isfinite(least))
        return;
    frequency.value.reset();
    frequency.words =
        Words::say("at least %1 Hz: this record does not tell the mass from zero").arg(digits(least));
}

} // namespace

std::vector<DerivedQuantity> derivedFrom(const UncertaintyBudget& budget)
{
    if (!budget.parameters || !(budget.parameters->vector().minCoeff() > 0))
        return {};
    const auto [m, b, k] = *budget.parameters;
    const double angular = std::sqrt(k) / std::sqrt(m);
    const double zeta = b / std::sqrt(m) / std::sqrt(k) / 2;
    if (!std::isfinite(angular) || !std::isfinite(zeta) || !(angular > 0) || !(zeta > 0))
        return {};
    const Eigen::Vector3d ofFrequency(-0.5, 0, 0.5);
    const Eigen::Vector3d ofDamping(-0.5, 1, -0.5);
    std::vector<DerivedQuantity> out;
    out.push_back(quantity(budget, u"natural_frequency"_s, Words::say("natural frequency"), u"Hz"_s,
                           {angular / twoPi, ofFrequency}));
    boundFrequency(budget, out.back());
    out.push_back(
        quantity(budget, u"damping_ratio"_s, Words::say("damping ratio"), u"1"_s, {zeta, ofDamping}));
    const double uncertainty = out.back().uncertainty.standardUncertainty;
    if (std::abs(zeta - 1) <= 2 * uncertainty) {
        DerivedQuantity both = quantity(budget, u"time_constant"_s, Words::say("time constant"), u"s"_s,
                                        {1 / angular, -ofFrequency});
        const Finding also =
            Words::say("the damping is critical within its uncertainty, so that two time constants cannot be "
                       "told apart");
        both.words = both.words.isEmpty() ? also : Finding::joined({both.words, also}, u"; "_s);
        out.push_back(both);
    } else if (zeta < 1) {
        // d ln sqrt(1 - zeta^2) = -zeta^2 / (1 - zeta^2) d ln zeta.
        const double rest = 1 - zeta * zeta;
        out.push_back(
            quantity(budget, u"damped_frequency"_s, Words::say("damped frequency"), u"Hz"_s,
                     {angular / twoPi * std::sqrt(rest), ofFrequency - zeta * zeta / rest * ofDamping}));
        out.push_back(quantity(budget, u"decay_time"_s, Words::say("decay time"), u"s"_s,
                               {1 / (zeta * angular), Eigen::Vector3d(1, -1, 0)}));
    } else {
        // tau = (zeta +- sqrt(zeta^2 - 1)) / angular; d ln tau = +-zeta / sqrt(zeta^2 - 1) d ln zeta - d ln
        // angular. The fast one as the reciprocal, so that nothing cancels.
        const double root = std::sqrt(zeta - 1) * std::sqrt(zeta + 1);
        const double sum = zeta + root;
        const Eigen::Vector3d slope = zeta / root * ofDamping;
        out.push_back(quantity(budget, u"time_constant_slow"_s, Words::say("slow time constant"), u"s"_s,
                               {sum / angular, slope - ofFrequency}));
        out.push_back(quantity(budget, u"time_constant_fast"_s, Words::say("fast time constant"), u"s"_s,
                               {1 / (sum * angular), -slope - ofFrequency}));
    }
    std::erase_if(out, [](const DerivedQuantity& q) {
        return !std::isfinite(q.interval.lower) || !std::isfinite(q.uncertainty.standardUncertainty);
    });
    return out;
}

} // namespace gripscope
