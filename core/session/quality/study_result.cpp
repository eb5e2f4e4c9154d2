// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/quality/study_result.h"

#include "core/base/words.h"
#include "core/quality/gauge/gauge_words.h"
#include "core/signal/recording/units.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <vector>

namespace gripscope {

using namespace Qt::StringLiterals;

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

/// What a gauge study comes to, in plain sentences: how many kinds of each quantity the gripper tells apart,
/// the most telling first; how many combinations by all of them together; whether operators are the trouble.
/// They are where their share of the gauge's variance is seen (p < 0.05 of the effect or its interaction) in
/// a quantity. The numbers behind it are in the study's own messages.
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

Expected<StudyResult> gaugeFound(const KeptStudy& study)
{
    ASSIGN_OR_RETURN(GaugeResult found, gaugeResult(study));
    Findings verdict = studyVerdict(found.study);
    return StudyResult{std::move(found), std::move(verdict)};
}

bool isInSi(const QString& unit, std::size_t quantity)
{
    const ParameterUnits si =
        comparableUnits(forceUnits().front(), positionUnits().front()); // any that are known
    return unit == std::array{si.m, si.b, si.k}[quantity];
}

tl::unexpected<Error> unreadable(const KeptStudy& study, const Finding& found, const Finding& wanted)
{
    return failure(ErrorCode::BadInput,
                   {Words::say("The study %1").arg(study.record.study.name), found, wanted});
}

Expected<StudyResult> typeOneFound(const KeptStudy& study)
{
    TypeOneResult found;
    const std::optional<double> tolerance = study.options.tolerances[std::size_t(study.plan.design.quantity)];
    if (!tolerance)
        return failure(ErrorCode::Usage, {Words::say("A type-1 study needs the tolerance of its quantity.")});
    ASSIGN_OR_RETURN(found.readings, referencedReadings(study));
    found.options.reference = found.readings.references.front();
    found.options.tolerance = *tolerance;
    found.options.quantity = found.readings.quantity;
    ASSIGN_OR_RETURN(found.study, studyTypeOne(found.readings.values, found.options));
    Findings verdict = found.study.messages;
    return StudyResult{std::move(found), std::move(verdict)};
}

Expected<StudyResult> linearityFound(const KeptStudy& study)
{
    LinearityResult found;
    ASSIGN_OR_RETURN(found.readings, referencedReadings(study));
    LinearityOptions options;
    options.quantity = found.readings.quantity;
    ASSIGN_OR_RETURN(found.study, studyLinearity(found.readings.references, found.readings.values, options));
    Findings verdict = found.study.messages;
    return StudyResult{std::move(found), std::move(verdict)};
}

Expected<StudyResult> agreementFound(const KeptStudy& study)
{
    RatingColumns columns;
    columns.part = u"part"_s;
    columns.rater = u"operator"_s; // who was there, where the plan names nobody
    columns.verdict = u"rating"_s;
    if (!study.plan.design.references.isEmpty())
        columns.reference = u"reference"_s;
    ASSIGN_OR_RETURN(const AttributeRatings ratings, readRatings(studyTable(study), columns));
    ASSIGN_OR_RETURN(AttributeAgreement found, studyAgreement(ratings));
    Findings verdict = found.messages;
    return StudyResult{std::move(found), std::move(verdict)};
}

Expected<StudyResult> foundOf(const KeptStudy& study)
{
    switch (study.plan.design.kind) {
    case StudyKind::Gauge:
        return gaugeFound(study);
    case StudyKind::TypeOne:
        return typeOneFound(study);
    case StudyKind::Linearity:
        return linearityFound(study);
    case StudyKind::Attributes:
        return agreementFound(study);
    case StudyKind::Transfer:
        break;
    }
    return failure(ErrorCode::Usage, {Words::say("Types on another gripper are judged squeeze by squeeze.")});
}

} // namespace

Expected<ReferencedReadings> referencedReadings(const KeptStudy& study)
{
    const auto quantity = std::size_t(study.plan.design.quantity);
    ReferencedReadings readings;
    for (const StudyMeasurementRecord* const one : study.counted()) {
        bool isNumber = false;
        const double reference = study.plan.reference(std::size_t(one->measured.row)).toDouble(&isNumber);
        const std::optional<StudyValue>& value = one->measured.values[quantity];
        if (!isNumber || !value)
            return unreadable(study, Words::say("a squeeze without its quantity or reference"),
                              Words::say("the quantity of the study from every squeeze"));
        const QString unit = one->measured.units[quantity];
        if (!readings.values.empty() && unit != readings.unit)
            return unreadable(study, Words::say("measurements in several units"),
                              Words::say("measurements in one unit"));
        readings.references.push_back(reference);
        readings.values.push_back(value->value);
        readings.unit = unit;
    }
    if (readings.values.empty())
        return unreadable(study, Words::say("nothing that counts was measured"),
                          Words::say("a squeeze or a verdict of every part"));
    if (isInSi(readings.unit, quantity))
        readings.quantity = static_cast<MechanicalQuantity>(quantity);
    return readings;
}

Expected<StudyResult> resultOf(const KeptStudy& study)
{
    if (study.counted().empty())
        return failure(ErrorCode::BadInput, {Words::say("The study %1").arg(study.record.study.name),
                                             Words::say("nothing that counts was measured"),
                                             Words::say("a squeeze or a verdict of every part")});
    ASSIGN_OR_RETURN(StudyResult result, foundOf(study));
    const StudyProgress progress = study.progress();
    result.left = progress.left();
    result.skipped = progress.skipped;
    result.repeated = progress.repeated;
    return result;
}

} // namespace gripscope
