// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/study_charts.h"

#include "ui/format/number_format.h"
#include "ui/format/reference_words.h"
#include "ui/format/shown_unit.h"

#include <algorithm>
#include <cmath>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

using Marks = CategoryChart::Marks;

/// A quantity of a study with the unit that it is shown in.
struct ShownStudy {
    const KeptStudy* study;
    const QuantitySummary* summary;
    std::size_t place = 0;
    ShownUnit unit;

    [[nodiscard]] const PlanDesign& design() const { return study->plan.design; }
    [[nodiscard]] int operatorCount() const { return std::max<int>(1, int(design().operators.size())); }
    [[nodiscard]] double shown(double value) const { return unit.factor * value; }
    [[nodiscard]] QString titled(const QString& words) const
    {
        const QString title = words.arg(ReferenceWords::quantity(place));
        return unit.unit.isEmpty() ? title : u"%1 (%2)"_s.arg(title, unit.unit);
    }
    /// Beside one another, so that what lies at the same place is seen.
    [[nodiscard]] double shiftOf(int person) const { return 0.6 * ((person + 0.5) / operatorCount() - 0.5); }
};

ShownStudy shownStudy(const KeptStudy& study, const QuantitySummary& summary)
{
    double largest = 0;
    for (const StudyCell& cell : summary.cells)
        largest = std::max(largest, std::abs(cell.mean));
    return {&study, &summary, StudyCharts::placeOf(summary.name), shownUnit(summary.unit, largest)};
}

CategoryChart componentsChart(const GaugeValue& value)
{
    CategoryChart chart;
    chart.title = StudyCharts::tr("Components of variation (%)");
    chart.fileName = u"study_components"_s;
    chart.fromZero = true;
    chart.top = 100;
    CategoryChart::Series contribution{StudyCharts::tr("of variance"), 0, Marks::Bars, {}};
    CategoryChart::Series variation{StudyCharts::tr("of study variation"), 1, Marks::Bars, {}};
    for (const GaugeComponent which :
         {GaugeComponent::Gauge, GaugeComponent::Repeatability, GaugeComponent::Operator,
          GaugeComponent::PartOperator, GaugeComponent::Station, GaugeComponent::PartStation,
          GaugeComponent::Part}) {
        const VarianceComponent* const found = value.find(which);
        if (found == nullptr)
            continue;
        const double x = double(chart.categories.size());
        contribution.points.emplace_back(x, found->percentContribution);
        variation.points.emplace_back(x, found->percentStudyVariation);
        chart.categories << StudyCharts::component(which);
    }
    chart.series = {contribution, variation};
    return chart;
}

/// Every measurement as a point, `category` says where; a series an operator.
void addMeasurements(CategoryChart& chart, const ShownStudy& shown, int PlanRow::*category, bool apart)
{
    const PlanDesign& design = shown.design();
    const std::size_t before = chart.series.size();
    for (int person = 0; person < shown.operatorCount(); ++person)
        chart.series.push_back({design.operators.value(person), person, Marks::Points, {}});
    for (const StudyMeasurementRecord* const one : shown.study->counted()) {
        const PlanRow& row = shown.study->plan.rows[std::size_t(one->measured.row)];
        const std::optional<StudyValue>& value = one->measured.values[shown.place];
        if (value)
            chart.series[before + std::size_t(row.operators)].points.emplace_back(
                row.*category + (apart ? shown.shiftOf(row.operators) : 0), shown.shown(value->value));
    }
}

CategoryChart::Series meansOf(const ShownStudy& shown, const std::vector<StudyMean>& means)
{
    CategoryChart::Series line{{}, -1, Marks::Lines, {}};
    for (const StudyMean& mean : means)
        line.points.emplace_back(mean.place, shown.shown(mean.mean));
    return line;
}

CategoryChart partsChart(const ShownStudy& shown)
{
    CategoryChart chart;
    chart.title = shown.titled(StudyCharts::tr("%1 by part"));
    chart.fileName = u"study_parts"_s;
    chart.categories = shown.design().parts;
    chart.categoryTitle = StudyCharts::tr("Part; the line joins the means");
    chart.series.push_back(meansOf(shown, shown.summary->parts));
    addMeasurements(chart, shown, &PlanRow::part, true);
    return chart;
}

CategoryChart operatorsChart(const ShownStudy& shown)
{
    CategoryChart chart;
    chart.title = shown.titled(StudyCharts::tr("%1 by operator"));
    chart.fileName = u"study_operators"_s;
    chart.empty = StudyCharts::tr("This study has no operators of its own.");
    chart.categories = shown.design().operators;
    chart.categoryTitle = StudyCharts::tr("Operator; the line joins the means");
    if (chart.categories.isEmpty())
        return chart;
    chart.series.push_back(meansOf(shown, shown.summary->operators));
    addMeasurements(chart, shown, &PlanRow::operators, false);
    for (CategoryChart::Series& series : chart.series)
        series.name.clear(); // they stand below
    return chart;
}

CategoryChart rangesChart(const ShownStudy& shown)
{
    CategoryChart chart;
    chart.title = shown.titled(StudyCharts::tr("%1: range by operator and part"));
    chart.fileName = u"study_ranges"_s;
    chart.fromZero = true;
    const PlanDesign& design = shown.design();
    const int parts = int(design.parts.size());
    for (int person = 0; person < shown.operatorCount(); ++person) {
        chart.categories << design.parts;
        chart.groups.push_back({design.operators.value(person), parts});
        chart.series.push_back({{}, person, Marks::Lines, {}});
    }
    for (const StudyCell& cell : shown.summary->cells)
        if (cell.count > 1)
            chart.series[std::size_t(cell.operators)].points.emplace_back(cell.operators * parts + cell.part,
                                                                          shown.shown(cell.range));
    chart.levels.push_back({shown.shown(shown.summary->meanRange), StudyCharts::tr("mean"), false});
    if (shown.summary->rangeUpper)
        chart.levels.push_back({shown.shown(*shown.summary->rangeUpper), StudyCharts::tr("limit"), true});
    if (shown.summary->rangeLower.value_or(0) > 0)
        chart.levels.push_back({shown.shown(*shown.summary->rangeLower), StudyCharts::tr("limit"), true});
    return chart;
}

CategoryChart interactionChart(const ShownStudy& shown)
{
    CategoryChart chart;
    chart.title = shown.titled(StudyCharts::tr("%1: mean by part and operator"));
    chart.fileName = u"study_interaction"_s;
    chart.categories = shown.design().parts;
    chart.categoryTitle = StudyCharts::tr("Part; lines that cross are parts on which operators disagree");
    for (int person = 0; person < shown.operatorCount(); ++person)
        chart.series.push_back({shown.design().operators.value(person), person, Marks::Lines, {}});
    for (const StudyCell& cell : shown.summary->cells)
        chart.series[std::size_t(cell.operators)].points.emplace_back(cell.part, shown.shown(cell.mean));
    return chart;
}

void addReadings(CategoryChart& chart, const ReferencedReadings& readings, const ShownUnit& unit)
{
    CategoryChart::Series series{{}, 0, Marks::Lines, {}};
    for (std::size_t i = 0; i < readings.values.size(); ++i) {
        chart.categories << QString::number(i + 1);
        series.points.emplace_back(double(i), unit.factor * readings.values[i]);
    }
    chart.series.push_back(series);
    if (!readings.references.empty())
        chart.levels.push_back(
            {unit.factor * readings.references.front(), StudyCharts::tr("reference"), false});
    chart.categoryTitle = StudyCharts::tr("Squeezes in their order");
}

void addBiases(CategoryChart& chart, const ReferencedReadings& readings, const ShownUnit& unit)
{
    std::vector<double> references = readings.references;
    std::ranges::sort(references);
    references.erase(std::ranges::unique(references).begin(), references.end());
    for (const double reference : references)
        chart.categories << formatNumber(unit.factor * reference, {}, {}).value;
    CategoryChart::Series series{{}, 0, Marks::Points, {}};
    for (std::size_t i = 0; i < readings.values.size(); ++i) {
        const auto place = std::ranges::lower_bound(references, readings.references[i]) - references.begin();
        series.points.emplace_back(double(place),
                                   unit.factor * (readings.values[i] - readings.references[i]));
    }
    chart.series.push_back(series);
    chart.levels.push_back({0, StudyCharts::tr("no bias"), false});
    chart.categoryTitle = StudyCharts::tr("Reference");
}

CategoryChart agreementChart(const AttributeAgreement& study)
{
    CategoryChart chart;
    chart.fileName = u"study_raters"_s;
    chart.title = StudyCharts::tr("Parts that each rater judges alike, and right (%)");
    chart.categoryTitle = StudyCharts::tr("Rater");
    chart.fromZero = true;
    chart.top = 100;
    CategoryChart::Series alike{StudyCharts::tr("alike each time"), 0, Marks::Bars, {}};
    CategoryChart::Series right{StudyCharts::tr("right each time"), 1, Marks::Bars, {}};
    for (const RaterAgreement& rater : study.raters) {
        const double x = double(chart.categories.size());
        if (const std::optional<double> share = rater.repeatability.value())
            alike.points.emplace_back(x, 100 * *share);
        if (const std::optional<double> share = rater.effectiveness.value())
            right.points.emplace_back(x, 100 * *share);
        chart.categories << rater.name;
    }
    for (const CategoryChart::Series& series : {alike, right})
        if (!series.points.empty())
            chart.series.push_back(series);
    return chart;
}

} // namespace

CategoryChart StudyCharts::single(const KeptStudy& study, const StudyResult& result)
{
    CategoryChart chart;
    chart.fileName = u"study_readings"_s;
    if (const auto* const agreement = result.as<AttributeAgreement>())
        return agreementChart(*agreement);
    const auto* const typeOne = result.as<TypeOneResult>();
    const auto* const linearity = result.as<LinearityResult>();
    if (typeOne == nullptr && linearity == nullptr)
        return chart;
    const ReferencedReadings& readings = typeOne != nullptr ? typeOne->readings : linearity->readings;
    const ShownUnit unit = shownUnit(readings.unit, readings.values.front());
    const QString name = ReferenceWords::quantity(std::size_t(study.plan.design.quantity));
    const QString title = (typeOne != nullptr ? tr("%1, squeeze by squeeze") : tr("%1: bias")).arg(name);
    chart.title = unit.unit.isEmpty() ? title : u"%1 (%2)"_s.arg(title, unit.unit);
    typeOne != nullptr ? addReadings(chart, readings, unit) : addBiases(chart, readings, unit);
    return chart;
}

QString StudyCharts::component(GaugeComponent component)
{
    switch (component) {
    case GaugeComponent::Repeatability:
        return tr("Repeatability");
    case GaugeComponent::Operator:
        return tr("Operator");
    case GaugeComponent::PartOperator:
        return tr("Part × operator");
    case GaugeComponent::Station:
        return tr("Station");
    case GaugeComponent::PartStation:
        return tr("Part × station");
    case GaugeComponent::Reproducibility:
        return tr("Reproducibility");
    case GaugeComponent::Gauge:
        return tr("Gauge");
    case GaugeComponent::Part:
        return tr("Part");
    case GaugeComponent::Total:
        return tr("Total");
    }
    return {};
}

std::size_t StudyCharts::placeOf(const QString& quantity)
{
    return quantity == u"k" ? 2 : quantity == u"b" ? 1 : 0;
}

std::array<CategoryChart, StudyCharts::count> StudyCharts::of(const KeptStudy& study,
                                                              const GaugeResult& result, std::size_t quantity)
{
    const ShownStudy shown = shownStudy(study, result.quantities[quantity]);
    return {componentsChart(result.study.values[quantity]), partsChart(shown), operatorsChart(shown),
            rangesChart(shown), interactionChart(shown)};
}

} // namespace gripscope
