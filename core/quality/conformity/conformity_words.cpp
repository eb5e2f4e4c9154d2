// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/words.h"
#include "core/quality/conformity/conformity.h"

#include <cmath>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

/// Less than this apart, value and limit read the same with three digits.
constexpr double readsTheSame = 0.006;

Finding amount(const Conformity& conformity, std::size_t place, double value)
{
    if (!conformity.siFactor)
        return Finding::number(value, 'g', 3);
    return Finding::quantity(MechanicalQuantity(place), value * *conformity.siFactor);
}

/// The limit that the value is beyond, or else nearest to.
double tellingLimit(const QuantityConformity& quantity)
{
    const ToleranceLimits& limits = quantity.limits;
    if (!limits.lower || !limits.upper)
        return limits.lower ? *limits.lower : limits.upper.value_or(0);
    const double middle = (*limits.lower + *limits.upper) / 2;
    return quantity.value.value_or(middle) < middle ? *limits.lower : *limits.upper;
}

/// "k 12.9 kN/m is above 12.5 kN/m".
Finding beyondInWords(const Conformity& conformity, std::size_t place)
{
    const QuantityConformity& quantity = *conformity.quantities[place];
    const double limit = tellingLimit(quantity);
    const double value = quantity.value.value_or(limit);
    const Finding name = quantitySymbol(place);
    const double apart = std::abs(value / limit - 1);
    if (apart < readsTheSame) {
        const Finding percent = Finding::number(100 * apart, 'g', 2);
        return value > limit
                   ? Words::say("%1 is %2 % above %3").arg(name, percent, amount(conformity, place, limit))
                   : Words::say("%1 is %2 % below %3").arg(name, percent, amount(conformity, place, limit));
    }
    const Finding is = amount(conformity, place, value);
    return value > limit ? Words::say("%1 %2 is above %3").arg(name, is, amount(conformity, place, limit))
                         : Words::say("%1 %2 is below %3").arg(name, is, amount(conformity, place, limit));
}

/// "k 12.4 kN/m (u 0.1 kN/m) against 12.5 kN/m, 16 % not to conform".
Finding nearInWords(const Conformity& conformity, std::size_t place)
{
    const QuantityConformity& quantity = *conformity.quantities[place];
    const double limit = tellingLimit(quantity);
    return Words::say("%1 %2 against %3, the risk not to conform is %4 %")
        .arg(quantitySymbol(place), amount(conformity, place, quantity.value.value_or(limit)),
             amount(conformity, place, limit), Finding::number(100 * quantity.risk.value_or(0), 'g', 2));
}

Finding undeterminedInWords(const Conformity& conformity, std::size_t place)
{
    return conformity.quantities[place]->value
               ? Words::say("how well it knows %1 is not known").arg(quantitySymbol(place))
               : Words::say("it does not determine %1").arg(quantitySymbol(place));
}

/// What is said of each quantity with that decision.
Finding tellingQuantities(const Conformity& conformity)
{
    Findings told;
    for (std::size_t i = 0; i < conformity.quantities.size(); ++i) {
        if (!conformity.quantities[i] || conformity.quantities[i]->decision != conformity.decision)
            continue;
        switch (conformity.decision) {
        case ConformityDecision::DoesNotConform:
            told.push_back(beyondInWords(conformity, i));
            break;
        case ConformityDecision::TooNearTheLimit:
            told.push_back(nearInWords(conformity, i));
            break;
        case ConformityDecision::NotDecidable:
            told.push_back(undeterminedInWords(conformity, i));
            break;
        case ConformityDecision::Conforms:
            break;
        }
    }
    return Finding::joined(std::move(told), u"; "_s);
}

} // namespace

Finding inWords(ConformityDecision decision)
{
    switch (decision) {
    case ConformityDecision::Conforms:
        return Words::say("conforms");
    case ConformityDecision::DoesNotConform:
        return Words::say("does not conform");
    case ConformityDecision::TooNearTheLimit:
        return Words::say("too near the limit for this squeeze");
    case ConformityDecision::NotDecidable:
        return Words::say("not decidable by this squeeze");
    }
    return {};
}

Finding inWords(const Conformity& conformity)
{
    const Finding decision = inWords(conformity.decision);
    const Finding told = tellingQuantities(conformity);
    return (told.isEmpty() ? decision : Words::say("%1: %2").arg(decision, told)).asSentence();
}

} // namespace gripscope
