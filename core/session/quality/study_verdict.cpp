// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/quality/study_verdict.h"

#include "core/base/words.h"
#include "core/quality/gauge/gauge_words.h"

#include <algorithm>
#include <cmath>

namespace gripscope {

namespace {

constexpr double effectSeenBelow = 0.05; // as the study's own messages have it

bool isEffectSeen(const GaugeValue& value, GaugeSource source)
{
    const bool isPooled = !value.pooledTable.empty() && source != GaugeSource::PartOperator;
    for (const VarianceRow& row : isPooled ? value.pooledTable : value.table)
        if (row.source == source && row.p && *row.p < effectSeenBelow)
            return true;
    return false;
}

Finding kindsTold(const GaugeValue& value)
{
    if (!value.distinctCategories)
        return Words::say("All repeats of %1 are equal, so nothing is known of how well it is measured.")
            .arg(value.name);
    const double kinds = std::floor(*value.distinctCategories);
    return kinds < 2
               ? Words::say("This gripper does not tell these parts apart by %1.").arg(value.name)
               : Words::say("This gripper tells %1 kinds of %2 apart.").arg(kinds, 'f', 0).arg(value.name);
}

/// A volume in the space of all values, which as a number of "kinds" would mislead: parts that differ in one
/// way only have no more kinds than by that one value.
Finding combinationsTold(const GaugeStudy& study)
{
    std::vector<Finding> names;
    for (const GaugeValue& value : study.values)
        names.emplace_back(value.name);
    const double kinds = std::floor(study.joint->kinds);
    const bool many = kinds > mostCombinationsTold;
    return (many ? Words::say(
                       "By %1 together it tells more than %2 combinations apart, such as stiff and light "
                       "from stiff and heavy, where parts come in all of them.")
                 : Words::say("By %1 together it tells up to %2 combinations apart, such as stiff and light "
                              "from stiff and heavy, where parts come in all of them."))
        .arg(Finding::joined(names, QStringLiteral(", ")))
        .arg(many ? mostCombinationsTold : kinds, 'f', 0);
}

std::optional<Finding> operatorsTold(const GaugeStudy& study)
{
    bool wereThere = false;
    const GaugeValue* worst = nullptr;
    double share = 0;
    for (const GaugeValue& value : study.values) {
        const VarianceComponent* const operators = value.find(GaugeComponent::Operator);
        if (operators == nullptr)
            continue;
        wereThere = true;
        const VarianceComponent* const both = value.find(GaugeComponent::PartOperator);
        const double gauge = value.find(GaugeComponent::Gauge)->taken;
        const double found = gauge > 0 ? (operators->taken + (both != nullptr ? both->taken : 0)) / gauge : 0;
        const bool isSeen =
            isEffectSeen(value, GaugeSource::Operator) || isEffectSeen(value, GaugeSource::PartOperator);
        if (isSeen && found >= share) {
            worst = &value;
            share = found;
        }
    }
    if (!wereThere)
        return std::nullopt;
    if (worst == nullptr)
        return Words::say("Operators are not the trouble.");
    return (share >= 0.5
                ? Words::say("Operators are the trouble: they make %1 % of the gauge's variance in %2.")
                : Words::say("Operators differ, but squeezes of one operator differ more: operators "
                             "make %1 % of the gauge's variance in %2."))
        .arg(100 * share, 'f', 0)
        .arg(worst->name);
}

} // namespace

Findings studyVerdict(const GaugeStudy& study)
{
    std::vector<const GaugeValue*> values;
    for (const GaugeValue& value : study.values)
        values.push_back(&value);
    std::ranges::stable_sort(values, std::greater<>(),
                             [](const GaugeValue* value) { return value->distinctCategories.value_or(0); });
    Findings verdict;
    for (const GaugeValue* const value : values)
        verdict.push_back(kindsTold(*value));
    if (study.joint && study.values.size() > 1)
        verdict.push_back(combinationsTold(study));
    if (const std::optional<Finding> operators = operatorsTold(study))
        verdict.push_back(*operators);
    return verdict;
}

} // namespace gripscope
