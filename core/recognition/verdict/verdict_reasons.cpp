// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/recognition/verdict/verdict_reasons.h"

#include "core/base/words.h"
#include "core/recognition/types/squeeze_values.h"
#include "core/recognition/verdict/quantity_text.h"

#include <algorithm>
#include <cmath>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

/// The squeeze less the type's mean, in standard deviations of each quantity on its own.
LogVector offsetsInDeviations(const TypeModels& models, const TypeModel& type, const LogVector& log)
{
    return (log - type.meanLog).cwiseQuotient(models.covarianceLog.diagonal().cwiseSqrt());
}

/// "Stiffness 9.98 kN/m", or only "Stiffness" where the numbers have no units.
Finding named(const QuantitySpace& space, Eigen::Index place, const LogVector& log, bool siUnits)
{
    const TypeQuantity quantity = space.quantities[std::size_t(place)];
    return siUnits ? nameOf(quantity) + u" "_s + valueOf(quantity, std::exp(log(place))) : nameOf(quantity);
}

Finding percent(double share)
{
    return shortNumber(100 * share) + u" %"_s;
}

/// "29 % below", "12 % above", "3.2 times"; `offset` is a difference of logarithms.
Finding comparedWith(double offset, const QString& type)
{
    const double ratio = std::exp(offset);
    if (ratio >= 2)
        return Words::say("%1 times that of %2").arg(shortNumber(ratio), type);
    if (ratio >= 1)
        return Words::say("%1 above that of %2").arg(percent(ratio - 1), type);
    return Words::say("%1 below that of %2").arg(percent(1 - ratio), type);
}

} // namespace

Findings typeReasons(const TypeModels& models, const TypeModel& type, const std::optional<NextType>& next,
                     const LogVector& log, const VerdictOptions& options)
{
    if (!next && models.reach == TypeModels::Reach::Group)
        return {Words::say("All that squeezes of %1 determine is where %1 sits.").arg(type.name)};
    if (!next && models.space.dimensions() == 1)
        return {Words::say("%1 is where %2 sits; it is the only type enrolled.")
                    .arg(nameOf(models.space.quantities.front()), type.name)};
    if (!next && models.space != QuantitySpace{})
        return {Words::say("Every quantity is where %1 sits; it is the only type enrolled.").arg(type.name)};
    if (!next)
        return {Words::say("Mass, damping and stiffness are where %1 sits; it is the only type enrolled.")
                    .arg(type.name)};
    // The quantity that tells the two types apart best.
    Eigen::Index place = 0;
    offsetsInDeviations(models, *next->type, log).cwiseAbs().maxCoeff(&place);
    return {Words::say("%1 is where %2 sits; the next type, %3, is %4 sd away.")
                .arg(named(models.space, place, log, options.siUnits), type.name, next->type->name,
                     shortNumber(next->deviations))};
}

Findings unknownReasons(const TypeModels& models, const TypeModel& nearest, const LogVector& log,
                        const Verdict& verdict, const VerdictOptions& options)
{
    Eigen::Index place = 0;
    const double most = offsetsInDeviations(models, nearest, log).cwiseAbs().maxCoeff(&place);
    const double offset = log(place) - nearest.meanLog(place);
    const double distance = std::sqrt(verdict.distance.value_or(0));
    const double gate = std::sqrt(verdict.gate.value_or(0));
    Findings reasons;
    reasons.push_back(
        Words::say("%1 is %2, the nearest type.")
            .arg(named(models.space, place, log, options.siUnits), comparedWith(offset, nearest.name)));
    reasons.push_back(Words::say("That is %1 sd away; squeezes of %2 stay within %3 sd.")
                          .arg(shortNumber(distance), nearest.name, shortNumber(gate)));
    // Each is near its usual value, but they do not go together as they do in the type.
    if (most < gate / 2 && models.space == QuantitySpace{})
        reasons.push_back(
            Words::say("Each of mass, damping and stiffness alone could be %1, but not the three together.")
                .arg(nearest.name));
    else if (most < gate / 2 && models.space.dimensions() > 1)
        reasons.push_back(
            Words::say("Each quantity alone could be %1, but not all of them together.").arg(nearest.name));
    return reasons;
}

Findings betweenTypesReasons(const Verdict& verdict, bool covarianceKnown)
{
    if (verdict.rival.isEmpty())
        return {};
    // The more probable first.
    QString first = verdict.nearest, second = verdict.rival;
    if (verdict.posterior.value(first) < verdict.posterior.value(second))
        first.swap(second);
    Findings reasons{Words::say("The squeeze could be %1 (%2) or %3 (%4).")
                         .arg(first, percent(verdict.posterior.value(first)), second,
                              percent(verdict.posterior.value(second)))};
    if (verdict.timesLonger && *verdict.timesLonger > 1.05)
        reasons.push_back(Words::say("Squeezed %1 times as long, nine of ten would tell them apart.")
                              .arg(shortNumber(*verdict.timesLonger)));
    else if (covarianceKnown && !verdict.timesLonger)
        reasons.push_back(
            Words::say("The two types lie so close that a longer squeeze would not tell them apart."));
    reasons.push_back(
        Words::say("Squeeze it again; if this happens often, enrol more squeezes of both types."));
    return reasons;
}

Findings strangerReasons(const QuantitySpace& space, const Verdict& verdict, double accepted)
{
    const bool atItsEdge = verdict.distance.value_or(0) > verdict.gate.value_or(0) / 4; // both are squares
    if (!atItsEdge && space.dimensions() < QuantitySpace{}.dimensions())
        return {
            Words::say("The squeeze is where %1 sits, but so would be too many other parts: by %2 alone, "
                       "more than %3 of those of no enrolled type would be named.")
                .arg(verdict.nearest, listed(space), percent(accepted)),
            Words::say(
                "A gripper or a recipe that determines more quantities decides, or a higher stranger-accept "
                "rate.")};
    return {Words::say(
                "The squeeze could be %1, but lies so far out that a part of no enrolled type is as likely.")
                .arg(verdict.nearest),
            Words::say("Squeeze it again; enrolling more squeezes narrows what %1 is.").arg(verdict.nearest)};
}

Findings noGateReasons(const TypeModels& models)
{
    if (models.types.empty())
        return {Words::say("No type is enrolled and approved yet.")};
    const int missing = models.space.dimensions() - models.degreesOfFreedom;
    if (missing <= 0)
        return {
            Words::say("The rate of false alarms asked for is too small for so few squeezes; enrol more.")};
    if (missing == 1)
        return {Words::say("Too few squeezes are enrolled to say what is usual: 1 more is needed.")};
    return {
        Words::say("Too few squeezes are enrolled to say what is usual: %1 more are needed.").arg(missing)};
}

Finding missingReason(const TypeSqueeze& squeeze, const QuantitySpace& space)
{
    if (space == QuantitySpace{})
        return Words::say("Mass, damping and stiffness are not all above zero.");
    if (space.quantities.empty())
        return Words::say("The squeezes enrolled have no quantity in common to judge by.");
    QuantitySpace missing{{}};
    for (const TypeQuantity quantity : space.quantities)
        if (!coordinatesOf(squeeze, QuantitySpace{{quantity}}))
            missing.quantities.push_back(quantity);
    if (missing.quantities.empty()) // each is there, but from two sources
        missing = space;
    return Words::say("The squeeze does not determine %1, by which the types are told apart.")
        .arg(listed(missing));
}

Findings spaceReasons(const TypeModels& models)
{
    const QuantitySpace& space = models.space;
    const bool plain = space == QuantitySpace{} && models.reach == TypeModels::Reach::Whole;
    if (plain || space.quantities.empty())
        return {};
    const Finding by = listed(space);
    const bool alone = space.dimensions() == 1;
    if (models.reach == TypeModels::Reach::Group)
        return {(alone ? Words::say("Judged by %1 alone, which not every type's squeezes determine.")
                       : Words::say("Judged by %1, which not every type's squeezes determine."))
                    .arg(by)};
    if (models.reach == TypeModels::Reach::Part)
        return {(alone ? Words::say("Judged by %1 alone: the squeeze determines no more.")
                       : Words::say("Judged by %1: the squeeze determines no more."))
                    .arg(by)};
    return {(alone ? Words::say("Judged by %1 alone: the squeezes enrolled determine no more.")
                   : Words::say("Judged by %1: the squeezes enrolled determine no more."))
                .arg(by)};
}

Findings invalidReasons(const Identification& identification)
{
    Findings reasons;
    if (identification.validity.verdict == ValidityVerdict::Invalid)
        reasons = summaryOf(identification.validity).reasons;
    if (!reasons.empty())
        return reasons;
    for (const Estimate& estimate : identification.estimates)
        if (estimate.estimator == identification.recommended && !estimate.message.isEmpty())
            reasons.push_back(estimate.message);
    if (reasons.empty())
        reasons.push_back(Words::say("No mass, damping and stiffness could be found from this squeeze."));
    return reasons;
}

} // namespace gripscope
