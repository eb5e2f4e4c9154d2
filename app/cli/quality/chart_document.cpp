// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/quality/chart_document.h"

#include "core/base/json_value.h"

#include <QJsonArray>
#include <QStringList>

namespace gripscope::cli {

using namespace Qt::StringLiterals;

namespace {

constexpr std::size_t mostLines = 500; // of a table on the screen

QJsonArray ruleArray(RuleSet rules)
{
    QJsonArray array;
    for (const int rule : rulesIn(rules))
        array.append(rule);
    return array;
}

QJsonObject pointObject(const ChartPoint& point, bool withSums)
{
    QJsonObject object{{u"value"_qs, jsonNumber(point.value)},
                       {u"lower"_qs, jsonNumber(point.lower)},
                       {u"upper"_qs, jsonNumber(point.upper)},
                       {u"rules"_qs, ruleArray(point.rules)}};
    if (withSums) {
        object[u"upper_sum"_qs] = jsonNumber(point.upperSum);
        object[u"lower_sum"_qs] = jsonNumber(point.lowerSum);
    }
    return object;
}

QJsonObject runLengthObject(const RunLengths& lengths)
{
    const auto points = [](const std::optional<RunLength>& length) {
        return length ? jsonNumber(length->points) : QJsonValue();
    };
    QJsonObject object{{u"in_control"_qs, points(lengths.inControl)},
                       {u"shift_1_sigma"_qs, points(lengths.shifted)}};
    if (lengths.inControl && lengths.inControl->standardError > 0)
        object[u"in_control_standard_error"_qs] = lengths.inControl->standardError;
    if (lengths.shifted && lengths.shifted->standardError > 0)
        object[u"shift_1_sigma_standard_error"_qs] = lengths.shifted->standardError;
    return object;
}

QJsonArray spreadArray(const ChartStudy& study)
{
    QJsonArray array;
    for (const std::optional<ChartPoint>& point : study.spreadPoints)
        array.append(point ? QJsonValue(pointObject(*point, false)) : QJsonValue());
    return array;
}

QJsonArray vectorArray(const Eigen::VectorXd& values)
{
    QJsonArray array;
    for (const double value : values)
        array.append(jsonNumber(value));
    return array;
}

QString lengthText(const std::optional<RunLength>& length)
{
    if (!length)
        return u"more than can be told"_qs;
    const QString points = QString::number(length->points, 'f', length->points < 100 ? 2 : 1);
    return length->standardError > 0
               ? u"%1 (simulated, standard error %2)"_qs.arg(points).arg(length->standardError, 0, 'g', 2)
               : points;
}

QString runLengthText(const RunLengths& lengths)
{
    return u"points until a signal, on average, with centre and sigma known: %1 while nothing has moved, %2 "
           "after a shift by 1 sigma"_qs.arg(lengthText(lengths.inControl), lengthText(lengths.shifted));
}

QString columnText(double value)
{
    return QString::number(value, 'g', 8).rightJustified(14);
}

QString ruleText(RuleSet rules)
{
    QStringList list;
    for (const int rule : rulesIn(rules))
        list << QString::number(rule);
    return list.isEmpty() ? QString() : u"  rule "_qs + list.join(u", "_qs);
}

QStringList pointLines(const ChartStudy& study)
{
    const bool sums = study.setting.kind == ChartKind::Cusum;
    QStringList lines{u" point         value         lower         upper"_qs +
                      (sums ? u"     upper sum     lower sum"_qs : QString())};
    for (std::size_t i = 0; i < study.points.size() && i < mostLines; ++i) {
        const ChartPoint& point = study.points[i];
        QString line = QString::number(i + 1).rightJustified(6) + columnText(point.value) +
                       columnText(point.lower) + columnText(point.upper);
        if (sums)
            line += columnText(point.upperSum) + columnText(point.lowerSum);
        line += ruleText(point.rules);
        if (i < study.spreadPoints.size() && study.spreadPoints[i] && study.spreadPoints[i]->rules != 0)
            line += u"  spread"_qs;
        lines << line;
    }
    if (study.points.size() > mostLines)
        lines << u"... %1 more; --json has them all"_qs.arg(study.points.size() - mostLines);
    return lines;
}

/// The first lines, and how many more there are.
QStringList shortened(const QStringList& lines, qsizetype all)
{
    QStringList shown = lines.mid(0, qsizetype(mostLines));
    if (all > shown.size())
        shown << u"... %1 more; --json has them all"_qs.arg(all - shown.size());
    return shown;
}

QString steadinessText(std::size_t signalCount, std::size_t points, const QString& first)
{
    if (signalCount == 0)
        return u"Steady: no signal in %1 points."_qs.arg(points);
    return u"Not steady: %1 in %2 points, the first at %3. Look for what changed there."_qs
        .arg(signalCount == 1 ? u"one signal"_qs : u"%1 signals"_qs.arg(signalCount))
        .arg(points)
        .arg(first);
}

} // namespace

QJsonObject chartDocument(const DrawnChart& chart)
{
    const ChartStudy& study = chart.study;
    const ChartSetting& setting = study.setting;
    QJsonArray points, told;
    for (const ChartPoint& point : study.points)
        points.append(pointObject(point, setting.kind == ChartKind::Cusum));
    for (const ChartSignal& signal : study.signalsFound)
        told.append(
            QJsonObject{{u"point"_qs, qint64(signal.point) + 1},
                        {u"chart"_qs, signal.part == ChartPart::Location ? u"location"_qs : u"spread"_qs},
                        {u"rule"_qs, signal.rule},
                        {u"since"_qs, signal.since ? QJsonValue(qint64(*signal.since) + 1) : QJsonValue()},
                        {u"words"_qs, signalInWords(signal, setting).english()}});
    QJsonObject document{{u"kind"_qs, toString(setting.kind)},
                         {u"centre"_qs, jsonNumber(setting.centre)},
                         {u"sigma"_qs, jsonNumber(setting.sigma)},
                         {u"sigma_method"_qs, study.spread ? toString(study.spread->method) : u"given"_qs},
                         {u"rules"_qs, toString(setting.rules)},
                         {u"points"_qs, points},
                         {u"signals"_qs, told},
                         {u"arl"_qs, runLengthObject(chart.runLengths)},
                         {u"messages"_qs, QJsonArray::fromStringList(english(study.messages))}};
    if (!study.spreadPoints.empty())
        document[u"spread_points"_qs] = spreadArray(study);
    return document;
}

QJsonObject chartDocument(const DrawnHotelling& chart)
{
    const HotellingStudy& study = chart.study;
    QJsonArray points, told, covariance;
    for (std::size_t i = 0; i < study.points.size(); ++i) {
        const HotellingPoint& point = study.points[i];
        points.append(QJsonObject{{u"value"_qs, jsonNumber(point.tSquared)},
                                  {u"lower"_qs, 0},
                                  {u"upper"_qs, jsonNumber(point.upper)},
                                  {u"rules"_qs, point.signal() ? QJsonArray{1} : QJsonArray()}});
        if (point.signal())
            told.append(
                QJsonObject{{u"point"_qs, qint64(i) + 1},
                            {u"chart"_qs, u"location"_qs},
                            {u"rule"_qs, 1},
                            {u"column"_qs, chart.columns[point.column]},
                            {u"words"_qs, hotellingInWords(i, chart.columns[point.column]).english()}});
    }
    for (Eigen::Index i = 0; i < study.reference.covariance.rows(); ++i)
        covariance.append(vectorArray(study.reference.covariance.row(i)));
    return {{u"kind"_qs, u"hotelling"_qs},
            {u"columns"_qs, QJsonArray::fromStringList(chart.columns)},
            {u"centre"_qs, vectorArray(study.reference.mean)},
            {u"sigma"_qs, vectorArray(study.reference.covariance.diagonal().cwiseSqrt())},
            {u"covariance"_qs, covariance},
            {u"points"_qs, points},
            {u"signals"_qs, told},
            {u"arl"_qs, runLengthObject(chart.runLengths)},
            {u"messages"_qs, QJsonArray::fromStringList(english(study.messages))}};
}

QString chartText(const DrawnChart& chart)
{
    const ChartStudy& study = chart.study;
    QStringList lines{u"%1: centre %2, sigma %3 (%4)"_qs.arg(
        toString(study.setting.kind), QString::number(study.setting.centre, 'g', 8),
        QString::number(study.setting.sigma, 'g', 7),
        study.spread ? toString(study.spread->method).replace(u'_', u' ') : u"given"_qs)};
    lines << pointLines(study);
    QStringList told;
    for (std::size_t i = 0; i < study.signalsFound.size() && i < mostLines; ++i)
        told << signalInWords(study.signalsFound[i], study.setting).describe();
    lines << shortened(told, qsizetype(study.signalsFound.size()));
    lines << runLengthText(chart.runLengths) << described(study.messages);
    lines << steadinessText(
        study.signalsFound.size(), study.points.size(),
        study.signalsFound.empty() ? QString() : u"point %1"_qs.arg(study.signalsFound.front().point + 1));
    return lines.join(u'\n');
}

QString chartText(const DrawnHotelling& chart)
{
    const HotellingStudy& study = chart.study;
    QStringList lines{u"hotelling: T^2 of %1"_qs.arg(chart.columns.join(u", "_qs)),
                      u" point           T^2         upper"_qs};
    QStringList told;
    std::size_t count = 0;
    QString first;
    for (std::size_t i = 0; i < study.points.size(); ++i) {
        const HotellingPoint& point = study.points[i];
        if (i < mostLines)
            lines << QString::number(i + 1).rightJustified(6) + columnText(point.tSquared) +
                         columnText(point.upper) + (point.signal() ? u"  above"_qs : QString());
        if (!point.signal())
            continue;
        ++count;
        if (first.isEmpty())
            first = u"point %1"_qs.arg(i + 1);
        if (count <= mostLines)
            told << hotellingInWords(i, chart.columns[point.column]).describe();
    }
    if (study.points.size() > mostLines)
        lines << u"... %1 more; --json has them all"_qs.arg(study.points.size() - mostLines);
    lines << shortened(told, qsizetype(count)) << runLengthText(chart.runLengths) << described(study.messages)
          << steadinessText(count, study.points.size(), first);
    return lines.join(u'\n');
}

} // namespace gripscope::cli
