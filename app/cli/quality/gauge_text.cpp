// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/quality/gauge_text.h"

#include "app/cli/line/output.h"

namespace gripscope::cli {

using namespace Qt::StringLiterals;

namespace {

QString sixDigits(std::optional<double> value)
{
    return value ? QString::number(*value, 'g', 6) : u"-"_qs;
}

QString intervalText(const VarianceInterval& interval)
{
    return u"%1 to %2"_qs.arg(QString::number(interval.lower, 'g', 4),
                              interval.upper ? QString::number(*interval.upper, 'g', 4) : u"any"_qs);
}

QStringList tableLines(const std::vector<VarianceRow>& table)
{
    QStringList lines;
    if (!table.empty())
        lines << u"%1      df            SS            MS          F          p"_qs.arg(u"source"_qs, -16);
    for (const VarianceRow& row : table)
        lines << u"%1 %2 %3 %4 %5 %6"_qs.arg(toString(row.source), -16)
                     .arg(sixDigits(row.degreesOfFreedom), 7)
                     .arg(sixDigits(row.sumOfSquares), 13)
                     .arg(sixDigits(row.meanSquare), 13)
                     .arg(row.f ? QString::number(*row.f, 'g', 4) : u"-"_qs, 10)
                     .arg(row.p ? QString::number(*row.p, 'g', 3) : u"-"_qs, 10);
    return lines;
}

QStringList componentLines(const GaugeValue& value)
{
    const bool tolerance = value.components.front().percentTolerance.has_value();
    QStringList lines{u"%1      variance  95 % interval          % contribution  % study variation%2"_qs
                          .arg(u"component"_qs, -16)
                          .arg(tolerance ? u"  % tolerance"_qs : QString())};
    for (const VarianceComponent& one : value.components) {
        QString row = u"%1 %2  %3 %4 %5"_qs.arg(toString(one.component), -16)
                          .arg(sixDigits(one.estimate), 13)
                          .arg(intervalText(one.interval), -22)
                          .arg(fixed(one.percentContribution, 2), 14)
                          .arg(fixed(one.percentStudyVariation, 2), 18);
        if (one.percentTolerance)
            row += fixed(one.percentTolerance, 2).rightJustified(13);
        lines << row;
    }
    lines << u"distinct categories %1 (%2)"_qs.arg(
        value.distinctCategories ? QString::number(*value.distinctCategories, 'f', 2) : u"-"_qs,
        intervalText(value.distinctCategoriesInterval));
    return lines;
}

QStringList valueLines(const GaugeValue& value)
{
    QStringList lines{u"%1: mean %2"_qs.arg(value.name, QString::number(value.mean, 'g', 8))};
    lines << tableLines(value.table) << componentLines(value) << described(value.messages);
    return lines;
}

} // namespace

QString gaugeText(const GaugeStudy& study)
{
    QStringList lines{u"%1 design, %2 parts, %3 measurements, %4; %5"_qs.arg(
        study.design == GaugeDesign::Nested ? u"nested"_qs : u"crossed"_qs, QString::number(study.parts),
        QString::number(study.rows), study.balanced ? u"balanced"_qs : u"not balanced"_qs,
        toString(study.method))};
    for (const GaugeValue& value : study.values)
        lines << QString() << valueLines(value);
    if (!study.jointMessages.empty())
        lines << QString() << described(study.jointMessages);
    return lines.join(u'\n');
}

} // namespace gripscope::cli
