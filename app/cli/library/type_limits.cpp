// SPDX-License-Identifier: GPL-3.0-or-later
// `types limits`: the tolerance limits of a type, and what they risk.
#include "app/cli/library/authorization.h"
#include "app/cli/library/type_commands.h"
#include "app/cli/library/type_library.h"
#include "app/cli/line/output.h"
#include "core/base/json_value.h"
#include "core/quality/conformity/part_limits.h"
#include "core/signal/recording/units.h"

#include <QJsonObject>

#include <algorithm>
#include <array>

namespace gripscope::cli {

using namespace Qt::StringLiterals;

namespace {

/// What is asked for; empty where the limits are only to be shown.
struct LimitsWanted {
    std::array<std::optional<ToleranceLimits>, 3> quantities;
    std::optional<ConformityRule> rule;
    std::optional<double> risk;
    bool none = false; ///< those that are there go first

    [[nodiscard]] bool changesAnything() const
    {
        return std::ranges::any_of(quantities, [](const auto& one) { return one.has_value(); }) || rule ||
               risk || none;
    }
    [[nodiscard]] PartLimits appliedTo(PartLimits limits) const
    {
        if (none)
            limits = {};
        for (std::size_t i = 0; i < quantities.size(); ++i)
            if (quantities[i])
                limits.quantities[i] = quantities[i];
        limits.rule = rule.value_or(limits.rule);
        limits.risk = risk.value_or(limits.risk);
        return limits;
    }
};

void addLimitOptions(CommandLine& line)
{
    for (std::size_t i = 0; i < 3; ++i)
        line.option(quantitySymbol(i), u"LOWER:UPPER"_s,
                    u"Limits of %1, in the units of the type's channels; either side may be left out."_s.arg(
                        quantitySymbol(i)));
    line.option(
        u"rule"_s, u"RULE"_s,
        u"iso14253: proven beyond a guard band of the expanded uncertainty, 95 %; simple: by the value "
        "alone; risk: proven up to --risk. At first iso14253."_s);
    line.option(u"risk"_s, u"SHARE"_s, u"Consumer's risk of the rule \"risk\"; at first 0.05."_s);
    line.flag(u"none"_s, u"Removes the limits that are there."_s);
}

LimitsWanted limitsWanted(CommandLine& line)
{
    LimitsWanted wanted;
    wanted.none = line.isSet(u"none"_s);
    for (std::size_t i = 0; i < wanted.quantities.size(); ++i) {
        const QString symbol = quantitySymbol(i);
        if (!line.isSet(symbol))
            continue;
        wanted.quantities[i] = toleranceLimitsFromText(line.text(symbol));
        if (!wanted.quantities[i])
            line.reject(u"--%1 \"%2\" is not LOWER:UPPER."_s.arg(symbol, line.text(symbol)));
    }
    if (line.isSet(u"rule"_s)) {
        wanted.rule = conformityRuleFromString(line.text(u"rule"_s));
        if (!wanted.rule)
            line.reject(u"--rule \"%1\" is none of iso14253, simple, risk."_s.arg(line.text(u"rule"_s)));
    }
    if (line.isSet(u"risk"_s))
        wanted.risk = line.number(u"risk"_s);
    if (wanted.changesAnything() && line.text(u"reason"_s).trimmed().isEmpty())
        line.reject(u"--reason is missing."_s);
    return wanted;
}

QJsonObject risksJson(const QuantityRisks& risks)
{
    return {{u"squeezes"_s, risks.squeezes},
            {u"mean"_s, jsonNumber(risks.mean)},
            {u"deviation"_s, jsonNumber(risks.deviation)},
            {u"deviation_is_of_squeezes"_s, risks.deviationIsOfSqueezes},
            {u"measurement_uncertainty"_s, jsonNumber(risks.uncertainty)},
            {u"guard"_s, jsonNumber(risks.guard)},
            {u"consumers_risk"_s, jsonNumber(risks.risks.consumers)},
            {u"producers_risk"_s, jsonNumber(risks.risks.producers)},
            {u"guard_for_risk"_s,
             QJsonObject{{QString::number(smallConsumersRisk), jsonNumber(risks.guardForSmallRisk)}}}};
}

QString unitOfPlace(const TypeRecord& type, std::size_t place)
{
    const ParameterUnits units = parameterUnits(type.forceUnit, type.positionUnit);
    return std::array{units.m, units.b, units.k}[place];
}

QJsonObject documentOf(const TypeRecord& type, const LimitRisks& risks)
{
    QJsonObject quantities;
    QJsonObject riskOf;
    for (std::size_t i = 0; i < risks.size(); ++i) {
        const std::optional<ToleranceLimits>& limits = type.limits.quantities[i];
        if (!limits)
            continue;
        quantities[quantitySymbol(i)] = QJsonObject{{u"lower"_s, jsonNumber(limits->lower)},
                                                    {u"upper"_s, jsonNumber(limits->upper)},
                                                    {u"unit"_s, unitOfPlace(type, i)}};
        riskOf[quantitySymbol(i)] = risks[i] ? QJsonValue(risksJson(*risks[i])) : QJsonValue();
    }
    const bool isRiskStated = type.limits.rule == ConformityRule::ConsumersRisk;
    return {{u"type"_s, type.name},
            {u"status"_s, toString(type.status)},
            {u"rule"_s, type.limits.isEmpty() ? QJsonValue() : QJsonValue(toString(type.limits.rule))},
            {u"risk"_s, isRiskStated ? QJsonValue(type.limits.risk) : QJsonValue()},
            {u"limits"_s, quantities},
            {u"risks"_s, riskOf}};
}

QString percent(double share)
{
    return QString::number(100 * share, 'g', 3) + u" %"_s;
}

QString textOf(const TypeRecord& type, const LimitRisks& risks)
{
    if (type.limits.isEmpty())
        return u"%1: no tolerance limits"_s.arg(type.name);
    QStringList lines{u"%1: %2"_s.arg(type.name, toText(type.limits))};
    for (std::size_t i = 0; i < risks.size(); ++i) {
        if (!type.limits.quantities[i])
            continue;
        if (!risks[i]) {
            lines << u"    %1: no risks without %2 squeezes of known uncertainty"_s.arg(quantitySymbol(i))
                         .arg(fewestForRisks);
            continue;
        }
        const QuantityRisks& r = *risks[i];
        lines << u"    %1 by %2 squeezes: parts %3 ± %4, a squeeze ± %5 %6 (standard)"_s
                     .arg(quantitySymbol(i))
                     .arg(r.squeezes)
                     .arg(r.mean, 0, 'g', 5)
                     .arg(r.deviation, 0, 'g', 3)
                     .arg(r.uncertainty, 0, 'g', 3)
                     .arg(unitOfPlace(type, i));
        lines << u"    consumer's risk %1, producer's risk %2 with a guard band of %3"_s.arg(
            percent(r.risks.consumers), percent(r.risks.producers), QString::number(r.guard, 'g', 3));
        if (r.deviationIsOfSqueezes)
            lines << u"    (the parts do not differ by more than the squeezes are uncertain)"_s;
    }
    return lines.join(u'\n');
}

Expected<TypeRecord> setLimits(Library& library, const TypeRecord& type, const LimitsWanted& wanted,
                               const CommandLine& line)
{
    const PartLimits limits = wanted.appliedTo(type.limits);
    if (limits.isEmpty() && !wanted.none)
        return failure(ErrorCode::Usage, {u"%1 has no limits that a rule could be for."_s.arg(type.name)});
    if (limits == type.limits)
        return failure(ErrorCode::Usage, {u"%1 has these limits already."_s.arg(type.name)});
    ASSIGN_OR_RETURN(const auto acting,
                     authorization(library, line.text(u"operator"_s), Permission::ChangeTypes));
    library.actAs(acting);
    return library.setTypeLimits(type.id, limits, note(line));
}

} // namespace

int typeLimits(const QStringList& arguments)
{
    CommandLine line(
        u"types limits"_s,
        u"The tolerance limits of a type, set or shown, and what they risk: parts that are "
        "recognised are then also said to conform, not to conform, or to be too near the limit."_s);
    addTypeOption(line);
    addLimitOptions(line);
    addNoteOptions(line);
    if (const auto exit = parseWith(line, arguments, {u"type"_s}))
        return *exit;
    const LimitsWanted wanted = limitsWanted(line);
    if (const auto exit = line.finish())
        return *exit;
    return withLibrary(line, [&](Library& library) -> Expected<void> {
        ASSIGN_OR_RETURN(TypeRecord type, requireNamed(library, line.text(u"type"_s)));
        if (wanted.changesAnything()) {
            ASSIGN_OR_RETURN(type, setLimits(library, type, wanted, line));
        }
        LimitRisks risks;
        if (!type.limits.isEmpty()) {
            ASSIGN_OR_RETURN(risks, library.typeRisks(type, type.limits));
        }
        if (line.isSet(u"json"_s))
            printJson(documentOf(type, risks));
        else
            print(textOf(type, risks));
        return {};
    });
}

} // namespace gripscope::cli
