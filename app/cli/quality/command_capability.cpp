// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/line/output.h"
#include "app/cli/quality/chart_input.h"
#include "app/cli/quality/quality_commands.h"
#include "core/base/json_value.h"
#include "core/quality/charts/box_cox.h"
#include "core/quality/charts/percentile_capability.h"

#include <QJsonArray>
#include <QJsonObject>

#include <array>

namespace gripscope::cli {

using namespace Qt::StringLiterals;

namespace {

enum class AssumedDistribution { Normal, BoxCox, Percentiles };

struct CapabilityTask {
    QString value, subgroup;
    CapabilityOptions options;
    AssumedDistribution distribution = AssumedDistribution::Normal;
    int resamples = 0;
    std::uint64_t seed = 1;
};

void addCapabilityOptions(CommandLine& line)
{
    addChartTableOptions(line);
    line.option(u"value"_qs, u"COL"_qs, u"Column that the limits are for."_qs);
    line.option(u"lower"_qs, u"L"_qs, u"Lower limit; without it only the upper one counts."_qs);
    line.option(u"upper"_qs, u"U"_qs, u"Upper limit; without it only the lower one counts."_qs);
    line.option(u"target"_qs, u"T"_qs, u"Of Cpm; without it the middle of the limits."_qs);
    line.option(
        u"subgroup"_qs, u"COL|N"_qs,
        u"Rows that belong together: with the same entry in a column, or so many in a row; without it "
        "sigma within is by moving ranges."_qs);
    line.option(u"within"_qs, u"METHOD"_qs,
                u"Sigma within: automatic, moving-range, range, deviation, pooled."_qs, u"automatic"_qs);
    line.option(u"distribution"_qs, u"NAME"_qs,
                u"normal; box-cox: a power makes the values normal; percentiles: of any distribution."_qs,
                u"normal"_qs);
    line.option(u"resamples"_qs, u"N"_qs, u"Of percentiles: bootstrap samples."_qs, u"4000"_qs);
    line.option(u"seed"_qs, u"N"_qs, u"Of what is drawn there."_qs, u"1"_qs);
}

CapabilityTask readCapabilityTask(CommandLine& line)
{
    CapabilityTask task;
    task.value = line.text(u"value"_qs);
    task.subgroup = line.text(u"subgroup"_qs);
    if (task.value.isEmpty())
        line.reject(u"--value is missing; the name of a column was expected."_qs);
    CapabilityOptions& options = task.options;
    for (const auto& [name, number] :
         {std::pair(u"lower"_qs, &options.limits.lower), std::pair(u"upper"_qs, &options.limits.upper),
          std::pair(u"target"_qs, &options.target)})
        if (line.isSet(name))
            *number = line.number(name);
    constexpr std::array methods{SpreadMethod::Automatic, SpreadMethod::MovingRange, SpreadMethod::Range,
                                 SpreadMethod::Deviation, SpreadMethod::Pooled};
    options.within = methods[std::size_t(
        std::max(0, line.choice(u"within"_qs, {u"automatic"_qs, u"moving-range"_qs, u"range"_qs,
                                               u"deviation"_qs, u"pooled"_qs})))];
    task.distribution = AssumedDistribution(
        std::max(0, line.choice(u"distribution"_qs, {u"normal"_qs, u"box-cox"_qs, u"percentiles"_qs})));
    task.resamples = line.integer(u"resamples"_qs, 200, 1'000'000);
    task.seed = line.seed();
    return task;
}

void addIndex(QJsonObject& object, const QString& name, const std::optional<CapabilityIndex>& index)
{
    object[name] = index ? jsonNumber(index->value) : QJsonValue();
    object[name + u"_interval"_qs] =
        index ? QJsonValue(jsonInterval(index->interval.lower, index->interval.upper)) : QJsonValue();
}

QJsonObject indicesObject(const CapabilityIndices& indices, const QString& letter)
{
    QJsonObject object{{u"sigma"_qs, jsonNumber(indices.sigma)},
                       {u"degrees_of_freedom"_qs, jsonNumber(indices.degreesOfFreedom)},
                       {letter + u"l"_qs, jsonNumber(indices.lower)},
                       {letter + u"u"_qs, jsonNumber(indices.upper)},
                       {u"expected_ppm"_qs, jsonNumber(indices.expectedPpm)}};
    addIndex(object, letter, indices.spread);
    addIndex(object, letter + u"k"_qs, indices.nearest);
    return object;
}

QJsonObject capabilityObject(const Capability& found)
{
    QJsonObject within = indicesObject(found.within, u"cp"_qs);
    within[u"method"_qs] = toString(found.spread.method);
    QJsonObject byEstimator{
        {u"degrees_of_freedom"_qs, jsonNumber(found.withinByEstimator.degreesOfFreedom)},
        {u"cpk_interval"_qs, jsonInterval(found.withinByEstimator.nearest.interval.lower,
                                          found.withinByEstimator.nearest.interval.upper)}};
    if (found.withinByEstimator.spread)
        byEstimator[u"cp_interval"_qs] = jsonInterval(found.withinByEstimator.spread->interval.lower,
                                                      found.withinByEstimator.spread->interval.upper);
    within[u"by_estimator"_qs] = byEstimator;
    QJsonObject overall = indicesObject(found.overall, u"pp"_qs);
    addIndex(overall, u"cpm"_qs, found.target);
    QJsonValue normality;
    if (found.normality)
        normality = QJsonObject{{u"anderson_darling"_qs, jsonNumber(found.normality->statistic)},
                                {u"adjusted"_qs, jsonNumber(found.normality->adjusted)},
                                {u"p"_qs, jsonNumber(found.normality->p)}};
    return {{u"count"_qs, qint64(found.count)},
            {u"mean"_qs, jsonNumber(found.mean)},
            {u"within"_qs, within},
            {u"overall"_qs, overall},
            {u"normality"_qs, normality},
            {u"expected_ppm"_qs, jsonNumber(found.overall.expectedPpm)},
            {u"observed_ppm"_qs, jsonNumber(found.observedPpm)},
            {u"verdict"_qs, capabilityVerdict(found.overall.nearest).english()},
            {u"messages"_qs, QJsonArray::fromStringList(english(found.messages))}};
}

QJsonObject percentileObject(const PercentileCapability& found)
{
    QJsonObject overall{{u"low"_qs, jsonNumber(found.low)},
                        {u"median"_qs, jsonNumber(found.median)},
                        {u"high"_qs, jsonNumber(found.high)}};
    addIndex(overall, u"pp"_qs, found.spread);
    addIndex(overall, u"ppk"_qs, found.nearest);
    return {{u"distribution"_qs, u"percentiles"_qs},
            {u"overall"_qs, overall},
            {u"observed_ppm"_qs, jsonNumber(found.observedPpm)},
            {u"verdict"_qs, capabilityVerdict(found.nearest).english()},
            {u"messages"_qs, QJsonArray::fromStringList(english(found.messages))}};
}

QString indexText(const QString& name, const std::optional<CapabilityIndex>& index)
{
    if (!index)
        return u"%1       -  (needs two limits)"_qs.arg(name, -5);
    return u"%1 %2  95 % interval %3 to %4"_qs.arg(name, -5).arg(fixed(index->value, 4).rightJustified(7),
                                                                 fixed(index->interval.lower, 4),
                                                                 fixed(index->interval.upper, 4));
}

QString capabilityText(const Capability& found)
{
    const CapabilityIndices& within = found.within;
    const CapabilityIndices& sure = found.withinByEstimator;
    QStringList lines{u"%1 values, mean %2"_qs.arg(found.count).arg(found.mean, 0, 'g', 8),
                      u"within: sigma %1 (%2)"_qs.arg(QString::number(within.sigma, 'g', 7),
                                                      toString(found.spread.method).replace(u'_', u' ')),
                      indexText(u"  Cp"_qs, within.spread), indexText(u"  Cpk"_qs, within.nearest)};
    lines << u"  by what that sigma is worth (%1 degrees of freedom): Cp %2 to %3, Cpk %4 to %5"_qs.arg(
                 fixed(sure.degreesOfFreedom, 1),
                 sure.spread ? fixed(sure.spread->interval.lower, 4) : u"-"_qs,
                 sure.spread ? fixed(sure.spread->interval.upper, 4) : u"-"_qs,
                 fixed(sure.nearest.interval.lower, 4), fixed(sure.nearest.interval.upper, 4))
          << u"overall: sigma %1"_qs.arg(found.overall.sigma, 0, 'g', 7)
          << indexText(u"  Pp"_qs, found.overall.spread) << indexText(u"  Ppk"_qs, found.overall.nearest)
          << indexText(u"  Cpm"_qs, found.target);
    if (found.normality)
        lines << u"normal? Anderson-Darling %1, p %2"_qs.arg(fixed(found.normality->statistic, 4))
                     .arg(found.normality->p, 0, 'g', 3);
    lines << u"beyond the limits: %1 ppm expected, %2 ppm observed"_qs.arg(
                 QString::number(found.overall.expectedPpm, 'g', 4),
                 QString::number(found.observedPpm, 'g', 4))
          << described(found.messages) << capabilityVerdict(found.overall.nearest).describe();
    return lines.join(u'\n');
}

QString percentileText(const PercentileCapability& found)
{
    QStringList lines{u"percentiles 0.135, 50 and 99.865 %: %1, %2, %3"_qs.arg(
                          QString::number(found.low, 'g', 8), QString::number(found.median, 'g', 8),
                          QString::number(found.high, 'g', 8)),
                      indexText(u"  Pp"_qs, found.spread), indexText(u"  Ppk"_qs, found.nearest),
                      u"beyond the limits: %1 ppm observed"_qs.arg(found.observedPpm, 0, 'g', 4)};
    lines << described(found.messages) << capabilityVerdict(found.nearest).describe();
    return lines.join(u'\n');
}

QJsonObject normalObject(const Capability& found)
{
    QJsonObject document = capabilityObject(found);
    document[u"distribution"_qs] = u"normal"_qs;
    return document;
}

QJsonObject transformedObject(const TransformedCapability& found)
{
    QJsonObject document = capabilityObject(found.capability);
    document[u"distribution"_qs] = u"box-cox"_qs;
    document[u"lambda"_qs] = jsonNumber(found.lambda);
    document[u"scale"_qs] = jsonNumber(found.scale);
    return document;
}

QString transformedText(const TransformedCapability& found)
{
    return u"values over %1, to the power of %2 (Box-Cox); the rest is of these\n%3"_qs.arg(
        QString::number(found.scale, 'g', 6), QString::number(found.lambda, 'g', 4),
        capabilityText(found.capability));
}

Expected<Subgroups> readCapabilityTable(const CommandLine& line, const CapabilityTask& task)
{
    ASSIGN_OR_RETURN(const ChartInput input, ChartInput::read(line, {task.value}));
    ASSIGN_OR_RETURN(const std::vector<double> values, input.numbers(task.value));
    ASSIGN_OR_RETURN(const SubgroupLayout layout, input.layout(task.subgroup));
    return Subgroups::of(layout, values);
}

} // namespace

int runCapabilityStudy(const QStringList& arguments)
{
    CommandLine line(u"study capability"_qs,
                     u"A process against the limits of its parts: Cp, Cpk, Pp, Ppk and Cpm with 95 % "
                     "intervals, whether the values are normal, and a way where they are not."_qs,
                     u"[TABLE.csv]"_qs);
    addCapabilityOptions(line);
    if (const std::optional<int> exit = line.parse(arguments))
        return *exit;
    const CapabilityTask task = readCapabilityTask(line);
    if (const std::optional<int> exit = line.finish())
        return *exit;
    const Expected<Subgroups> groups = readCapabilityTable(line, task);
    if (!groups)
        return fail(groups.error(), line.isSet(u"json"_qs));
    switch (task.distribution) {
    case AssumedDistribution::Normal:
        return showStudy(studyCapability(*groups, task.options), line, normalObject, capabilityText);
    case AssumedDistribution::BoxCox:
        return showStudy(studyBoxCoxCapability(*groups, task.options), line, transformedObject,
                         transformedText);
    case AssumedDistribution::Percentiles:
        break;
    }
    PercentileOptions options{task.options.limits, task.options.confidence, task.resamples, task.seed};
    return showStudy(studyPercentileCapability(groups->values, options), line, percentileObject,
                     percentileText);
}

} // namespace gripscope::cli
