// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/p_value_words.h"
#include "core/quality/gauge/gauge_words.h"
#include "ui/charts/study_charts.h"
#include "ui/format/number_format.h"
#include "ui/reports/quality_reports.h"

#include <cmath>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

constexpr int studyDigits = 4; // of what has no error of its own: references and limits have as many

QString studyQuantity(double value, const QString& unit, std::optional<double> error = {})
{
    return formatNumber(value, error, unit, studyDigits).valueWithUnit();
}

QString studyInterval(const std::optional<TwoSidedInterval>& interval, const QString& unit)
{
    return interval ? StudyNumbers::tr("%1 to %2")
                          .arg(formatNumber(interval->lower, {}, unit).valueWithUnit(),
                               formatNumber(interval->upper, {}, unit).valueWithUnit())
                    : u"–"_s;
}

QString varianceInterval(const VarianceInterval& interval, const QString& unit)
{
    const QString lower = formatNumber(std::sqrt(std::max(0.0, interval.lower)), {}, unit).valueWithUnit();
    return interval.upper
               ? StudyNumbers::tr("%1 to %2")
                     .arg(lower, formatNumber(std::sqrt(*interval.upper), {}, unit).valueWithUnit())
               : StudyNumbers::tr("%1 or more").arg(lower);
}

StudyNumbersTable componentNumbers(const GaugeResult& result, std::size_t quantity)
{
    const GaugeValue& value = result.study.values[quantity];
    const QString unit = result.quantities[quantity].unit;
    const bool withTolerance = value.components.front().percentTolerance.has_value();
    StudyNumbersTable table{StudyNumbers::tr("Components of variation"),
                            {StudyNumbers::tr("Source"), StudyNumbers::tr("Standard deviation"),
                             StudyNumbers::tr("95 % interval"), StudyNumbers::tr("of variance"),
                             StudyNumbers::tr("of study variation")},
                            {}};
    if (withTolerance)
        table.heads << StudyNumbers::tr("of tolerance");
    for (const VarianceComponent& component : value.components) {
        QStringList row{StudyCharts::component(component.component),
                        formatNumber(std::sqrt(component.taken), {}, unit).valueWithUnit(),
                        varianceInterval(component.interval, unit),
                        formatPercent(component.percentContribution),
                        formatPercent(component.percentStudyVariation)};
        if (withTolerance)
            row << formatPercent(component.percentTolerance.value_or(0));
        table.rows.push_back(row);
    }
    return table;
}

StudyNumbersTable typeOneNumbers(const TypeOneResult& result)
{
    const TypeOneStudy& study = result.study;
    const QString unit = result.readings.unit, none = u"–"_s;
    const auto capability = [&none](std::optional<double> value) {
        return value ? formatNumber(*value, {}, {}).value : none;
    };
    const double error = study.repeatability / std::sqrt(double(std::max<std::size_t>(study.count, 1)));
    StudyNumbersTable table{
        StudyNumbers::tr("Figures"),
        {StudyNumbers::tr("Figure"), StudyNumbers::tr("Value"), StudyNumbers::tr("95 % interval")},
        {{StudyNumbers::tr("Readings"), formatCount(qint64(study.count)), none},
         {StudyNumbers::tr("Reference"), studyQuantity(result.options.reference, unit), none},
         {StudyNumbers::tr("Tolerance"), studyQuantity(result.options.tolerance, unit), none},
         {StudyNumbers::tr("Mean"), studyQuantity(study.mean, unit, error), none},
         {StudyNumbers::tr("Bias"), formatNumber(study.bias, {}, unit).valueWithUnit(),
          studyInterval(study.biasInterval, unit)},
         {StudyNumbers::tr("Repeatability (standard deviation)"),
          formatNumber(study.repeatability, {}, unit).valueWithUnit(),
          studyInterval(study.repeatabilityInterval, unit)},
         {u"Cg"_s, capability(study.cg), studyInterval(study.cgInterval, {})},
         {u"Cgk"_s, capability(study.cgk), studyInterval(study.cgkInterval, {})},
         {StudyNumbers::tr("Share of the tolerance that the scatter takes"),
          formatPercent(study.variationPercent), none}}};
    if (study.step)
        table.rows.push_back({StudyNumbers::tr("Smallest step between readings"),
                              formatNumber(*study.step, {}, unit).valueWithUnit(), none});
    return table;
}

QStringList biasCells(const QString& name, const ReferenceBias& bias, const QString& unit)
{
    return {name, formatCount(qint64(bias.count)), formatNumber(bias.bias, {}, unit).valueWithUnit(),
            studyInterval(bias.interval, unit), bias.p ? pValueInWords(*bias.p).describe() : u"–"_s};
}

StudyNumbersTable linearityNumbers(const LinearityResult& result)
{
    const QString unit = result.readings.unit;
    StudyNumbersTable table{StudyNumbers::tr("Bias at each reference"),
                            {StudyNumbers::tr("Reference"), StudyNumbers::tr("Readings"),
                             StudyNumbers::tr("Bias"), StudyNumbers::tr("95 % interval"),
                             StudyNumbers::tr("Test of no bias")},
                            {}};
    for (const ReferenceBias& bias : result.study.references)
        table.rows.push_back(biasCells(studyQuantity(bias.reference, unit), bias, unit));
    table.rows.push_back(biasCells(StudyNumbers::tr("All"), result.study.average, unit));
    return table;
}

QString shareText(const AgreementShare& share, bool withLimits)
{
    if (!share.value())
        return u"–"_s;
    const QString percent = formatPercent(100 * *share.value());
    return withLimits ? StudyNumbers::tr("%1 (95 %: %2 to %3)")
                            .arg(percent, formatPercent(100 * share.lower), formatPercent(100 * share.upper))
                      : percent;
}

StudyNumbersTable agreementNumbers(const AttributeAgreement& study)
{
    StudyNumbersTable table{StudyNumbers::tr("Raters"),
                            {StudyNumbers::tr("Rater"), StudyNumbers::tr("Verdicts"),
                             StudyNumbers::tr("Parts judged alike each time")},
                            {}};
    if (study.hasReference)
        table.heads << StudyNumbers::tr("Parts judged right each time") << StudyNumbers::tr("Misses")
                    << StudyNumbers::tr("False alarms");
    for (const RaterAgreement& rater : study.raters) {
        QStringList row{rater.name, formatCount(rater.ratings), shareText(rater.repeatability, true)};
        if (study.hasReference)
            row << shareText(rater.effectiveness, true) << shareText(rater.misses, false)
                << shareText(rater.falseAlarms, false);
        table.rows.push_back(row);
    }
    if (study.raters.size() > 1) {
        QStringList row{StudyNumbers::tr("All together"), u""_s, shareText(study.all, true)};
        if (study.hasReference)
            row << shareText(study.allRight, true) << u"–"_s << u"–"_s;
        table.rows.push_back(row);
    }
    return table;
}

} // namespace

StudyNumbersTable StudyNumbers::of(const StudyResult& result, std::size_t quantity)
{
    if (const GaugeResult* const gauge = result.gauge())
        return componentNumbers(*gauge, quantity);
    if (const auto* const typeOne = result.as<TypeOneResult>())
        return typeOneNumbers(*typeOne);
    if (const auto* const linearity = result.as<LinearityResult>())
        return linearityNumbers(*linearity);
    return agreementNumbers(*result.as<AttributeAgreement>());
}

QStringList StudyNumbers::categories(const GaugeResult& result)
{
    QStringList lines;
    const auto number = [](double kinds) { return formatNumber(kinds, {}, {}).value; };
    for (std::size_t i = result.study.values.size(); i-- > 0;) {
        const GaugeValue& value = result.study.values[i];
        if (!value.distinctCategories) {
            lines << tr("%1: all repeats are equal").arg(value.name);
            continue;
        }
        const VarianceInterval& interval = value.distinctCategoriesInterval;
        lines << (interval.upper
                      ? tr("%1: %2 (95 %: %3 to %4)")
                            .arg(value.name, number(*value.distinctCategories), number(interval.lower),
                                 number(*interval.upper))
                      : tr("%1: %2 (95 %: %3 or more)")
                            .arg(value.name, number(*value.distinctCategories), number(interval.lower)));
    }
    if (result.study.joint)
        lines
            << (result.study.joint->kinds > mostCombinationsTold
                    ? tr("combinations of them: more than %1").arg(formatCount(qint64(mostCombinationsTold)))
                    : tr("combinations of them: up to %1")
                          .arg(formatCount(qint64(result.study.joint->kinds))));
    return lines;
}

QStringList StudyNumbers::remarks(const GaugeResult& result, std::size_t quantity)
{
    return described(result.study.values[quantity].messages);
}

} // namespace gripscope
