// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/quality/conformity/part_limits.h"

#include "core/base/csv.h"
#include "core/base/words.h"

#include <QStringList>

#include <algorithm>
#include <cmath>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

constexpr std::array allConformityRules{ConformityRule::Iso14253, ConformityRule::Simple,
                                        ConformityRule::ConsumersRisk};

std::optional<double> limitNumber(const QString& text)
{
    const QByteArray utf8 = text.trimmed().toUtf8();
    const std::optional<double> number = parseNumber({utf8.constData(), std::size_t(utf8.size())});
    return number && std::isfinite(*number) ? number : std::nullopt;
}

std::optional<Error> refusedLimits(const Finding& words)
{
    return Error{ErrorCode::Usage, {words}};
}

/// Takes "key=value" into the limits; false where it is none of theirs.
bool takeField(PartLimits& limits, const QString& key, const QString& value)
{
    if (key == u"rule"_s) {
        const std::optional<ConformityRule> rule = conformityRuleFromString(value);
        limits.rule = rule.value_or(limits.rule);
        return rule.has_value();
    }
    if (key == u"risk"_s) {
        const std::optional<double> risk = limitNumber(value);
        limits.risk = risk.value_or(limits.risk);
        return risk.has_value();
    }
    for (std::size_t i = 0; i < limits.quantities.size(); ++i)
        if (key == quantitySymbol(i)) {
            limits.quantities[i] = toleranceLimitsFromText(value);
            return limits.quantities[i].has_value();
        }
    return false;
}

} // namespace

QString toString(ConformityRule rule)
{
    switch (rule) {
    case ConformityRule::Iso14253:
        return u"iso14253"_s;
    case ConformityRule::Simple:
        return u"simple"_s;
    case ConformityRule::ConsumersRisk:
        return u"risk"_s;
    }
    return {};
}

std::optional<ConformityRule> conformityRuleFromString(const QString& text)
{
    for (const ConformityRule rule : allConformityRules)
        if (toString(rule) == text)
            return rule;
    return {};
}

bool PartLimits::isEmpty() const
{
    return std::ranges::none_of(quantities, [](const auto& limits) { return limits.has_value(); });
}

std::optional<Error> PartLimits::validate() const
{
    if (isEmpty())
        return refusedLimits(Words::say("no limit is given: a lower one, an upper one or both"));
    for (const std::optional<ToleranceLimits>& limits : quantities) {
        if (!limits)
            continue;
        if (std::optional<Error> problem = limits->validate())
            return problem;
        for (const std::optional<double>& limit : {limits->lower, limits->upper})
            if (limit && !(*limit > 0))
                return refusedLimits(Words::say("a limit of m, b or k is not above zero"));
    }
    if (!(risk > 0 && risk < 0.5))
        return refusedLimits(Words::say("the consumer's risk is above 0 and below 0.5"));
    return std::nullopt;
}

QString quantitySymbol(std::size_t place)
{
    constexpr std::array symbols{u'm', u'b', u'k'};
    return place < symbols.size() ? QString(symbols[place]) : QString();
}

QString toText(const ToleranceLimits& limits)
{
    return exactText(limits.lower) + u':' + exactText(limits.upper);
}

std::optional<ToleranceLimits> toleranceLimitsFromText(const QString& text)
{
    const QStringList sides = text.split(u':');
    if (sides.size() != 2)
        return {};
    ToleranceLimits limits;
    const std::array<std::optional<double>*, 2> targets{&limits.lower, &limits.upper};
    for (std::size_t i = 0; i < targets.size(); ++i) {
        const QString side = sides[qsizetype(i)].trimmed();
        *targets[i] = limitNumber(side);
        if (!side.isEmpty() && !*targets[i])
            return {};
    }
    return limits;
}

QString toText(const PartLimits& limits)
{
    if (limits.isEmpty())
        return {};
    QStringList fields;
    for (std::size_t i = 0; i < limits.quantities.size(); ++i)
        if (limits.quantities[i])
            fields << quantitySymbol(i) + u'=' + toText(*limits.quantities[i]);
    fields << u"rule="_s + toString(limits.rule);
    if (limits.rule == ConformityRule::ConsumersRisk)
        fields << u"risk="_s + exactText(limits.risk);
    return fields.join(u' ');
}

std::optional<PartLimits> partLimitsFromText(const QString& text)
{
    PartLimits limits;
    for (const QString& field : text.split(u' ', Qt::SkipEmptyParts)) {
        const qsizetype equals = field.indexOf(u'=');
        if (equals < 0 || !takeField(limits, field.left(equals), field.mid(equals + 1)))
            return {};
    }
    if (!limits.isEmpty() && limits.validate())
        return {};
    return limits;
}

} // namespace gripscope
