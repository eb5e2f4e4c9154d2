// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/quality/gauge/gauge_words.h"

#include "core/base/p_value_words.h"
#include "core/base/words.h"

#include <algorithm>
#include <cmath>

namespace gripscope {

namespace {

/// An effect is seen where chance alone does as much in one of twenty studies.
constexpr double seenBelow = 0.05;

Finding sourceWords(GaugeComponent component)
{
    switch (component) {
    case GaugeComponent::Repeatability:
        return Words::say("repeatability");
    case GaugeComponent::Operator:
        return Words::say("the operators");
    case GaugeComponent::PartOperator:
        return Words::say("the interaction of part and operator");
    case GaugeComponent::Station:
        return Words::say("the stations");
    case GaugeComponent::PartStation:
        return Words::say("the interaction of part and station");
    case GaugeComponent::Part:
        return Words::say("the parts");
    default:
        return Words::say("the gauge");
    }
}

bool isSingleSource(GaugeComponent component)
{
    return component != GaugeComponent::Reproducibility && component != GaugeComponent::Gauge &&
           component != GaugeComponent::Total;
}

const VarianceComponent& largestOf(const GaugeValue& value, bool withParts)
{
    const VarianceComponent* largest = nullptr;
    for (const VarianceComponent& one : value.components)
        if (isSingleSource(one.component) && (withParts || one.component != GaugeComponent::Part) &&
            (largest == nullptr || one.taken > largest->taken))
            largest = &one;
    return *largest;
}

std::optional<VarianceRow> rowOf(const std::vector<VarianceRow>& table, GaugeSource source)
{
    const auto found = std::ranges::find(table, source, &VarianceRow::source);
    return found == table.end() ? std::nullopt : std::optional(*found);
}

bool isSeen(const std::optional<VarianceRow>& row)
{
    return row && row->p && *row->p < seenBelow;
}

Finding verdictMessage(const GaugeValue& value)
{
    const VarianceComponent& gauge = *value.find(GaugeComponent::Gauge);
    Finding verdict;
    switch (gaugeGrade(value)) {
    case GaugeGrade::Good:
        verdict = Words::say("This gripper is good enough to judge these parts: the gauge takes %1 % of the "
                             "study variation (below 10 %).");
        break;
    case GaugeGrade::Usable:
        verdict = Words::say("This gripper may do, depending on what is at stake: the gauge takes %1 % of "
                             "the study variation (up to 10 % is good, above 30 % is not).");
        break;
    case GaugeGrade::NotGoodEnough:
        verdict = Words::say("This gripper is not good enough to judge these parts: the gauge takes %1 % of "
                             "the study variation (at most 30 %, better 10 %).");
        break;
    }
    verdict = verdict.arg(gauge.percentStudyVariation, 'f', 1);
    if (gauge.percentTolerance)
        verdict += Words::say(" It takes %1 % of the tolerance.").arg(*gauge.percentTolerance, 'f', 1);
    return verdict;
}

Finding categoriesMessage(const GaugeValue& value)
{
    if (!value.distinctCategories)
        return Words::say(
            "Nothing of the gauge was seen at all: its repeats are equal. Check that the values "
            "have enough digits and that no row was copied.");
    const double kinds = std::floor(*value.distinctCategories);
    if (kinds < 1)
        return Words::say("It cannot tell these parts apart.");
    Finding message = (kinds < leastDistinctCategories
                           ? Words::say("It tells %1 kinds of part apart, where five are the least.")
                           : Words::say("It tells %1 kinds of part apart."))
                          .arg(kinds, 'f', 0);
    const VarianceInterval& interval = value.distinctCategoriesInterval;
    if (kinds >= leastDistinctCategories && interval.lower < leastDistinctCategories)
        message += Words::say(" With so few measurements it may be as few as %1.")
                       .arg(std::floor(interval.lower), 'f', 0);
    return message;
}

Finding dominatingMessage(const GaugeValue& value)
{
    const VarianceComponent& all = largestOf(value, true);
    const VarianceComponent& gauge = largestOf(value, false);
    const double ofGauge = value.find(GaugeComponent::Gauge)->taken;
    Finding message = Words::say("Most of the variance comes from %1 (%2 %)")
                          .arg(sourceWords(all.component))
                          .arg(all.percentContribution, 'f', 1);
    if (&all == &gauge || !(ofGauge > 0))
        return message + Finding(u".");
    return message + Words::say(", most of the gauge's own from %1 (%2 % of it).")
                         .arg(sourceWords(gauge.component))
                         .arg(100 * gauge.taken / ofGauge, 'f', 0);
}

/// Whether operators, or stations, matter.
std::optional<Finding> factorMessage(const GaugeValue& value, GaugeSource source, GaugeSource interaction)
{
    const VarianceComponent* component = value.find(componentOf(source));
    if (component == nullptr)
        return std::nullopt;
    const bool operators = source == GaugeSource::Operator;
    const std::optional<VarianceRow> both = rowOf(value.table, interaction);
    const std::optional<VarianceRow> row =
        rowOf(value.pooledTable.empty() ? value.table : value.pooledTable, source);
    if (isSeen(both))
        return (operators ? Words::say("Operators differ from part to part (interaction, %1): they grip some "
                                       "parts differently. Look where, and how those parts are put in.")
                          : Words::say("Stations differ from part to part (interaction, %1). Look at "
                                       "which parts, and how they sit there."))
            .arg(pValueInWords(*both->p));
    if (isSeen(row))
        return (operators ? Words::say("Operators matter: they differ (%1) and make %2 % of the "
                                       "variance. Agree on one way to put the part in and to start.")
                          : Words::say("Stations matter: they differ (%1) and make %2 % of the "
                                       "variance. Calibrate them against each other."))
            .arg(pValueInWords(*row->p))
            .arg(component->percentContribution, 'f', 1);
    if (row && row->p)
        return (operators ? Words::say("Operators are not the trouble: no difference between them is seen "
                                       "(%1).")
                          : Words::say("Stations are not the trouble: no difference between them is seen "
                                       "(%1)."))
            .arg(pValueInWords(*row->p));
    return (operators ? Words::say("Operators make %1 % of the variance.")
                      : Words::say("Stations make %1 % of the variance."))
        .arg(component->percentContribution, 'f', 1);
}

Finding nextMessage(const GaugeValue& value)
{
    if (gaugeGrade(value) == GaugeGrade::Good)
        return Words::say("Next: use it, and repeat the study after repairs, new fingers or a new operator.");
    const GaugeComponent worst = largestOf(value, false).component;
    if (worst != GaugeComponent::Repeatability)
        return Words::say(
                   "Next: reduce what comes from %1, then repeat the study; until then let one operator "
                   "at one station measure what is to be compared.")
            .arg(sourceWords(worst));
    // Averaging n squeezes divides repeatability by n: how many make the gauge usable?
    const double repeatability = value.find(GaugeComponent::Repeatability)->taken;
    const double part = value.find(GaugeComponent::Part)->taken;
    const double others = value.find(GaugeComponent::Gauge)->taken - repeatability;
    const double share = usableGaugePercent * usableGaugePercent / 1e4;
    const double allowed =
        std::min(part * share / (1 - share), 2 * part / (leastDistinctCategories * leastDistinctCategories));
    const double squeezes = allowed > others ? std::ceil(repeatability / (allowed - others)) : 1e9;
    if (squeezes > 1 && squeezes <= 50)
        return Words::say("Next: squeeze each part %1 times and take the mean, or make the squeeze itself "
                          "repeat better (stronger or longer excitation, a firmer seat), then repeat the "
                          "study.")
            .arg(squeezes, 'f', 0);
    return Words::say("Next: make the squeeze itself repeat better (stronger or longer excitation, a firmer "
                      "seat), and choose parts that differ as production does, then repeat the study.");
}

void addEstimateMessages(const GaugeValue& value, const GaugeOptions& options, Findings& messages)
{
    for (const GaugeSource source : value.pooled) {
        const VarianceRow row = *rowOf(value.table, source);
        messages.push_back(Words::say("Pooled: %1 is not seen (F = %2, p = %3, above %4) and counts as "
                                      "repeatability; without pooling it is kept.")
                               .arg(sourceWords(componentOf(source)))
                               .arg(row.f.value_or(0), 'g', 3)
                               .arg(row.p.value_or(1), 'f', 3)
                               .arg(options.pooledAbove, 'g', 3));
    }
    for (const VarianceComponent& one : value.components)
        if (one.estimate < 0)
            messages.push_back(
                Words::say("The estimated variance of %1 is negative (%2) and is taken as 0 in "
                           "all sums: it is too small for this table to see.")
                    .arg(sourceWords(one.component))
                    .arg(one.estimate, 'g', 4));
    for (const GaugeSource source : value.atBoundary)
        messages.push_back(Words::say("The variance of %1 is estimated as 0, the least that it can be: it is "
                                      "too small for this table to see.")
                               .arg(sourceWords(componentOf(source))));
    if (!value.converged)
        messages.push_back(Words::say("The likelihood was not maximised to the last digits: take the "
                                      "components as approximate."));
}

void addConsistencyMessage(const RepeatConsistency& found, Findings& messages)
{
    if (found.above < seenBelow / 2)
        messages.push_back(
            Words::say("Repeats scatter %1 times as much as the squeezes' own uncertainties say (%2): "
                       "something that a squeeze does not see, such as how the part sits, differs from "
                       "squeeze to squeeze.")
                .arg(found.ratio, 'g', 3)
                .arg(pValueInWords(found.above)));
    else if (found.below < seenBelow / 2)
        messages.push_back(
            Words::say("Repeats scatter only %1 times as much as the squeezes' own uncertainties say "
                       "(%2): these are stated too large, or hold what all squeezes have in common.")
                .arg(found.ratio, 'g', 3)
                .arg(pValueInWords(found.below)));
    else
        messages.push_back(Words::say("Repeats scatter as the squeezes' own uncertainties say (%1 times, "
                                      "%2).")
                               .arg(found.ratio, 'g', 3)
                               .arg(pValueInWords(found.above)));
}

} // namespace

GaugeGrade gaugeGrade(const GaugeValue& value)
{
    const VarianceComponent& gauge = *value.find(GaugeComponent::Gauge);
    const double worst = std::max(gauge.percentStudyVariation, gauge.percentTolerance.value_or(0));
    if (worst > usableGaugePercent ||
        (value.distinctCategories && *value.distinctCategories < leastDistinctCategories))
        return GaugeGrade::NotGoodEnough;
    return worst > goodGaugePercent ? GaugeGrade::Usable : GaugeGrade::Good;
}

Findings gaugeMessages(const GaugeValue& value, const GaugeLayout& layout, const GaugeOptions& options)
{
    Findings messages{verdictMessage(value), categoriesMessage(value), dominatingMessage(value)};
    if (const auto message = factorMessage(value, GaugeSource::Operator, GaugeSource::PartOperator))
        messages.push_back(*message);
    if (const auto message = factorMessage(value, GaugeSource::Station, GaugeSource::PartStation))
        messages.push_back(*message);
    messages.push_back(nextMessage(value));
    if (value.consistency)
        addConsistencyMessage(*value.consistency, messages);
    addEstimateMessages(value, options, messages);
    for (const Finding& message : layout.messages)
        messages.push_back(message);
    return messages;
}

Findings jointGaugeMessages(const GaugeStudy& study)
{
    if (!study.joint)
        return {Words::say("The values cannot be judged together: one of them repeats exactly, or is "
                           "determined by the others.")};
    const auto best = std::ranges::max_element(
        study.values, {}, [](const GaugeValue& value) { return value.distinctCategories.value_or(0); });
    Findings messages{
        Words::say("Together the values tell up to %1 combinations apart, as many as that only where parts "
                   "come in all of them; the best of them alone (%2) tells %3 kinds of part.")
            .arg(std::floor(study.joint->kinds), 'f', 0)
            .arg(best->name)
            .arg(std::floor(best->distinctCategories.value_or(0)), 'f', 0)};
    if (study.joint->partProjected)
        messages.push_back(Words::say("Along some combination of the values the parts' estimated variance is "
                                      "negative; it is taken as 0."));
    return messages;
}

} // namespace gripscope
