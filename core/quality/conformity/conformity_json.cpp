// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/quality/conformity/conformity_json.h"

#include "core/base/json_value.h"

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

std::optional<double> numberAt(const QJsonObject& object, const QString& key)
{
    const QJsonValue value = object.value(key);
    return value.isDouble() ? std::optional(value.toDouble()) : std::nullopt;
}

QJsonObject quantityJson(const QuantityConformity& quantity)
{
    return {{u"decision"_s, toString(quantity.decision)},
            {u"value"_s, jsonNumber(quantity.value)},
            {u"standard_uncertainty"_s, jsonNumber(quantity.standardUncertainty)},
            {u"lower"_s, jsonNumber(quantity.limits.lower)},
            {u"upper"_s, jsonNumber(quantity.limits.upper)},
            {u"guard"_s, jsonNumber(quantity.guard)},
            {u"risk"_s, jsonNumber(quantity.risk)}};
}

std::optional<QuantityConformity> quantityFromJson(const QJsonObject& document)
{
    const auto decision = conformityDecisionFromString(document.value(u"decision"_s).toString());
    if (!decision)
        return {};
    return QuantityConformity{*decision,
                              {numberAt(document, u"lower"_s), numberAt(document, u"upper"_s)},
                              numberAt(document, u"value"_s),
                              numberAt(document, u"standard_uncertainty"_s),
                              numberAt(document, u"guard"_s),
                              numberAt(document, u"risk"_s)};
}

} // namespace

QJsonObject conformityJson(const Conformity& conformity)
{
    QJsonObject quantities;
    for (std::size_t i = 0; i < conformity.quantities.size(); ++i)
        if (conformity.quantities[i])
            quantities.insert(quantitySymbol(i), quantityJson(*conformity.quantities[i]));
    const bool isRiskStated = conformity.rule == ConformityRule::ConsumersRisk;
    return {{u"decision"_s, toString(conformity.decision)},
            {u"rule"_s, toString(conformity.rule)},
            {u"risk"_s, isRiskStated ? QJsonValue(conformity.statedRisk) : QJsonValue()},
            {u"si_factor"_s, jsonNumber(conformity.siFactor)},
            {u"quantities"_s, quantities}};
}

std::optional<Conformity> conformityFromJson(const QJsonObject& document)
{
    const auto decision = conformityDecisionFromString(document.value(u"decision"_s).toString());
    const auto rule = conformityRuleFromString(document.value(u"rule"_s).toString());
    if (!decision || !rule)
        return {};
    Conformity conformity;
    conformity.decision = *decision;
    conformity.rule = *rule;
    conformity.statedRisk = numberAt(document, u"risk"_s).value_or(conformity.statedRisk);
    conformity.siFactor = numberAt(document, u"si_factor"_s);
    const QJsonObject quantities = document.value(u"quantities"_s).toObject();
    for (std::size_t i = 0; i < conformity.quantities.size(); ++i) {
        const QJsonValue quantity = quantities.value(quantitySymbol(i));
        if (!quantity.isObject())
            continue;
        conformity.quantities[i] = quantityFromJson(quantity.toObject());
        if (!conformity.quantities[i])
            return {};
    }
    return conformity;
}

} // namespace gripscope
