// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/quality/conformity/conformity.h"

#include "core/math/distributions.h"

#include <algorithm>
#include <cmath>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

constexpr double isoRisk = 0.05; ///< ISO 14253-1:2017, 5: a conformance probability of 95 %
constexpr std::array allConformityDecisions{ConformityDecision::Conforms, ConformityDecision::DoesNotConform,
                                            ConformityDecision::TooNearTheLimit,
                                            ConformityDecision::NotDecidable};

/// So far above zero, in standard uncertainties: the probability beyond.
double tailBeyond(double deviations, const std::optional<double>& degreesOfFreedom)
{
    return degreesOfFreedom ? studentAbove(deviations, *degreesOfFreedom) : normalBelow(-deviations);
}

double quantileBeyond(double tail, const std::optional<double>& degreesOfFreedom)
{
    return degreesOfFreedom ? studentQuantileAbove(tail, *degreesOfFreedom) : normalQuantileAbove(tail);
}

double guardFactor(const PartLimits& limits, const std::optional<double>& degreesOfFreedom)
{
    switch (limits.rule) {
    case ConformityRule::Iso14253:
        return quantileBeyond(isoRisk, degreesOfFreedom);
    case ConformityRule::ConsumersRisk:
        return quantileBeyond(limits.risk, degreesOfFreedom);
    case ConformityRule::Simple:
        break;
    }
    return 0;
}

double specificRisk(const ToleranceLimits& limits, const MeasuredValue& measured)
{
    const double u = *measured.standardUncertainty;
    double risk = 0;
    if (limits.lower)
        risk += tailBeyond((measured.value - *limits.lower) / u, measured.degreesOfFreedom);
    if (limits.upper)
        risk += tailBeyond((*limits.upper - measured.value) / u, measured.degreesOfFreedom);
    return std::clamp(risk, 0.0, 1.0);
}

ConformityDecision byGuard(const ToleranceLimits& limits, double value, double guard)
{
    const bool within = (!limits.lower || value >= *limits.lower + guard) &&
                        (!limits.upper || value <= *limits.upper - guard);
    if (within)
        return ConformityDecision::Conforms;
    const bool beyond =
        (limits.lower && value <= *limits.lower - guard) || (limits.upper && value >= *limits.upper + guard);
    return beyond ? ConformityDecision::DoesNotConform : ConformityDecision::TooNearTheLimit;
}

ConformityDecision byRisk(double risk, double stated)
{
    switch (decide(1 - risk, stated)) {
    case PartDecision::Conforms:
        return ConformityDecision::Conforms;
    case PartDecision::DoesNotConform:
        return ConformityDecision::DoesNotConform;
    case PartDecision::TooNearTheLimit:
        break;
    }
    return ConformityDecision::TooNearTheLimit;
}

bool isUsableUncertainty(const MeasuredValue& measured)
{
    const std::optional<double>& u = measured.standardUncertainty;
    const std::optional<double>& v = measured.degreesOfFreedom;
    return u && std::isfinite(*u) && *u > 0 && (!v || (std::isfinite(*v) && *v > 0));
}

QuantityConformity judgeQuantity(const PartLimits& limits, const ToleranceLimits& own,
                                 const std::optional<MeasuredValue>& measured)
{
    QuantityConformity found{ConformityDecision::NotDecidable, own};
    if (!measured || !std::isfinite(measured->value))
        return found;
    found.value = measured->value;
    if (isUsableUncertainty(*measured)) {
        found.standardUncertainty = measured->standardUncertainty;
        found.risk = specificRisk(own, *measured);
        found.guard = guardFactor(limits, measured->degreesOfFreedom) * *measured->standardUncertainty;
    }
    if (limits.rule == ConformityRule::Simple) {
        found.guard = 0;
        found.decision = byGuard(own, measured->value, 0);
    } else if (found.risk) {
        found.decision = limits.rule == ConformityRule::ConsumersRisk
                             ? byRisk(*found.risk, limits.risk)
                             : byGuard(own, measured->value, *found.guard);
    }
    return found;
}

ConformityDecision overall(const Conformity& conformity)
{
    const auto isAny = [&conformity](ConformityDecision decision) {
        return std::ranges::any_of(conformity.quantities, [decision](const auto& quantity) {
            return quantity && quantity->decision == decision;
        });
    };
    for (const ConformityDecision decision :
         {ConformityDecision::DoesNotConform, ConformityDecision::TooNearTheLimit,
          ConformityDecision::NotDecidable})
        if (isAny(decision))
            return decision;
    return ConformityDecision::Conforms;
}

} // namespace

QString toString(ConformityDecision decision)
{
    switch (decision) {
    case ConformityDecision::Conforms:
        return u"conforms"_s;
    case ConformityDecision::DoesNotConform:
        return u"does_not_conform"_s;
    case ConformityDecision::TooNearTheLimit:
        return u"too_near_the_limit"_s;
    case ConformityDecision::NotDecidable:
        return u"not_decidable"_s;
    }
    return {};
}

std::optional<ConformityDecision> conformityDecisionFromString(const QString& text)
{
    for (const ConformityDecision decision : allConformityDecisions)
        if (toString(decision) == text)
            return decision;
    return {};
}

Expected<Conformity> judgeConformity(const PartLimits& limits, const MeasuredValues& measured,
                                     const std::optional<double>& siFactor)
{
    if (std::optional<Error> problem = limits.validate())
        return tl::unexpected(*problem);
    Conformity conformity;
    conformity.rule = limits.rule;
    conformity.statedRisk = limits.risk;
    conformity.siFactor = siFactor;
    for (std::size_t i = 0; i < measured.size(); ++i)
        if (limits.quantities[i])
            conformity.quantities[i] = judgeQuantity(limits, *limits.quantities[i], measured[i]);
    conformity.decision = overall(conformity);
    return conformity;
}

} // namespace gripscope
