// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/line/output.h"
#include "app/cli/quality/chart_document.h"
#include "app/cli/quality/chart_input.h"
#include "app/cli/quality/quality_commands.h"

#include <array>
#include <cmath>

namespace gripscope::cli {

using namespace Qt::StringLiterals;

namespace {

struct ChartTask {
    QStringList values;
    bool hotelling = false;
    QString subgroup;
    ChartOptions options;
    double falseAlarm = 0.0027;
};

constexpr std::array chartKinds{ChartKind::Individuals, ChartKind::MeanRange, ChartKind::MeanDeviation,
                                ChartKind::Ewma, ChartKind::Cusum};
const QStringList chartKindNames{u"i-mr"_qs, u"xbar-r"_qs, u"xbar-s"_qs,
                                 u"ewma"_qs, u"cusum"_qs,  u"hotelling"_qs};

void addChartOptions(CommandLine& line)
{
    addChartTableOptions(line);
    line.option(u"value"_qs, u"COL"_qs, u"Column that is charted; of hotelling several, with commas."_qs);
    line.option(u"kind"_qs, u"KIND"_qs, chartKindNames.join(u", "_qs), u"i-mr"_qs);
    line.option(u"subgroup"_qs, u"COL|N"_qs,
                u"Rows that belong together: with the same entry in a column, or so many in a row."_qs);
    line.option(u"target"_qs, u"T"_qs, u"The centre; without it the mean of the values."_qs);
    line.option(u"sigma"_qs, u"S"_qs, u"Of one value; without it as it shows within subgroups."_qs);
    line.option(u"rules"_qs, u"RULES"_qs,
                u"Signals besides a point beyond its limits: western-electric, nelson, none."_qs, u"none"_qs);
    line.option(u"lambda"_qs, u"W"_qs, u"EWMA: weight of the newest point."_qs, u"0.2"_qs);
    line.option(u"width"_qs, u"L"_qs, u"EWMA: limits, in standard deviations of the average."_qs, u"3"_qs);
    line.option(u"k"_qs, u"K"_qs, u"CUSUM: reference value, in standard deviations of a point."_qs,
                u"0.5"_qs);
    line.option(u"h"_qs, u"H"_qs, u"CUSUM: decision interval, in the same."_qs, u"5"_qs);
    line.option(u"false-alarm"_qs, u"SHARE"_qs, u"Hotelling: of points beyond the limit by chance."_qs,
                u"0.0027"_qs);
    line.option(
        u"phase-one"_qs, u"N"_qs,
        u"The first N points settle the limits, the others are judged by them; without it all do."_qs);
}

void checkChartTask(CommandLine& line, const ChartTask& task)
{
    if (task.values.isEmpty())
        line.reject(u"--value is missing; the name of a column was expected."_qs);
    if (!task.hotelling && task.values.size() > 1)
        line.reject(u"--value names several columns; only --kind hotelling takes more than one."_qs);
    if (task.hotelling && (task.options.target || task.options.sigma))
        line.reject(u"--target and --sigma are of one column; --kind hotelling takes them from the table "
                    "(--phase-one)."_qs);
    const bool means = !task.hotelling && (task.options.kind == ChartKind::MeanRange ||
                                           task.options.kind == ChartKind::MeanDeviation);
    if (means && task.subgroup.isEmpty())
        line.reject(u"--subgroup is missing; a column or a number of rows was expected, or --kind i-mr."_qs);
    if (task.falseAlarm > 0.5)
        line.reject(u"--false-alarm is %1; a share of at most 0.5 was expected."_qs.arg(task.falseAlarm));
}

ChartTask readChartTask(CommandLine& line)
{
    ChartTask task;
    task.values = line.list(u"value"_qs);
    const int kind = line.choice(u"kind"_qs, chartKindNames);
    task.hotelling = kind == int(chartKinds.size());
    if (!task.hotelling)
        task.options.kind = chartKinds[std::size_t(std::max(0, kind))];
    task.subgroup = line.text(u"subgroup"_qs);
    if (line.isSet(u"target"_qs))
        task.options.target = line.number(u"target"_qs);
    if (line.isSet(u"sigma"_qs))
        task.options.sigma = line.number(u"sigma"_qs, CommandLine::Range::Positive);
    constexpr std::array rules{RunRules::WesternElectric, RunRules::Nelson, RunRules::None};
    task.options.rules = rules[std::size_t(
        std::max(0, line.choice(u"rules"_qs, {u"western-electric"_qs, u"nelson"_qs, u"none"_qs})))];
    task.options.weight = line.number(u"lambda"_qs, CommandLine::Range::Positive);
    task.options.width = line.number(u"width"_qs, CommandLine::Range::Positive);
    task.options.reference = line.number(u"k"_qs, CommandLine::Range::NotNegative);
    task.options.decision = line.number(u"h"_qs, CommandLine::Range::Positive);
    task.falseAlarm = line.number(u"false-alarm"_qs, CommandLine::Range::Positive);
    if (line.isSet(u"phase-one"_qs))
        task.options.estimateFrom = std::size_t(line.integer(u"phase-one"_qs, 2, 1'000'000'000));
    checkChartTask(line, task);
    return task;
}

Expected<DrawnChart> drawChart(const ChartInput& input, const SubgroupLayout& layout, const ChartTask& task)
{
    ASSIGN_OR_RETURN(const std::vector<double> values, input.numbers(task.values.front()));
    ASSIGN_OR_RETURN(const Subgroups groups, Subgroups::of(layout, values));
    ASSIGN_OR_RETURN(ChartStudy study, studyChart(groups, task.options));
    const RunLengths lengths = runLengths(study.setting);
    return DrawnChart{std::move(study), lengths};
}

Expected<DrawnHotelling> drawHotelling(const ChartInput& input, const SubgroupLayout& layout,
                                       const ChartTask& task)
{
    std::vector<std::vector<double>> columns;
    for (const QString& name : task.values) {
        ASSIGN_OR_RETURN(std::vector<double> values, input.numbers(name));
        columns.push_back(std::move(values));
    }
    ASSIGN_OR_RETURN(HotellingStudy study,
                     studyHotelling(layout, columns, {task.falseAlarm, task.options.estimateFrom}));
    const double size = double(layout.rows()) / double(layout.subgroups());
    const int count = int(task.values.size());
    const RunLengths lengths{RunLength{hotellingRunLength(count, task.falseAlarm, 0), 0},
                             RunLength{hotellingRunLength(count, task.falseAlarm, 1, size), 0}};
    return DrawnHotelling{std::move(study), task.values, lengths};
}

} // namespace

int runChartStudy(const QStringList& arguments)
{
    CommandLine line(
        u"study chart"_qs,
        u"A table's values as a control chart: limits, points beyond them, run rules, and how many "
        "points it takes until a signal."_qs,
        u"[TABLE.csv]"_qs);
    addChartOptions(line);
    if (const std::optional<int> exit = line.parse(arguments))
        return *exit;
    const ChartTask task = readChartTask(line);
    if (const std::optional<int> exit = line.finish())
        return *exit;
    const bool json = line.isSet(u"json"_qs);
    const Expected<ChartInput> input = ChartInput::read(line, task.values);
    if (!input)
        return fail(input.error(), json);
    const Expected<SubgroupLayout> layout = input->layout(task.subgroup);
    if (!layout)
        return fail(layout.error(), json);
    const auto document = [](const auto& chart) { return chartDocument(chart); };
    const auto text = [](const auto& chart) { return chartText(chart); };
    return task.hotelling ? showStudy(drawHotelling(*input, *layout, task), line, document, text)
                          : showStudy(drawChart(*input, *layout, task), line, document, text);
}

} // namespace gripscope::cli
