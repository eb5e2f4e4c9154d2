// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/process/process_chart.h"

#include "core/base/words.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace gripscope {

namespace {

constexpr std::uint32_t anyName = std::numeric_limits<std::uint32_t>::max();

/// Where a name that is asked for stands; nothing where it is not there.
std::optional<std::uint32_t> nameAsked(const QStringList& names, const QString& name)
{
    if (name.isEmpty())
        return anyName;
    const qsizetype place = names.indexOf(name);
    return place < 0 ? std::nullopt : std::optional(std::uint32_t(place));
}

tl::unexpected<Error> unitsThatDiffer()
{
    return failure(ErrorCode::BadInput,
                   {Words::say("The inspections"),
                    Words::say("their m, b and k are in units that cannot be compared"),
                    Words::say("choose one gripper, or state the units of its channels")});
}

/// Rows that have this quantity, and its values.
struct DeterminedRows {
    ProcessRows rows;
    std::vector<double> values;
};

DeterminedRows determinedRows(const ProcessValues& values, const ProcessRows& rows, std::size_t quantity)
{
    const SharedColumn<double>& column = values.quantities[quantity];
    DeterminedRows found;
    found.rows.reserve(rows.size());
    found.values.reserve(rows.size());
    for (const std::uint32_t row : rows)
        if (std::isfinite(column[row])) {
            found.rows.push_back(row);
            found.values.push_back(column[row]);
        }
    return found;
}

/// What the charts themselves (ChartOptions) and their run lengths (ChartSetting) are asked with alike.
template <typename Setting>
Setting chartSettingOf(const ProcessOptions& options)
{
    Setting setting;
    setting.kind = chartKindOf(options.kind);
    setting.rules = takesRules(options.kind) ? options.rules : RunRules::None;
    setting.weight = options.weight;
    setting.width = options.width;
    setting.reference = options.reference;
    setting.decision = options.decision;
    return setting;
}

ChartOptions chartOptionsOf(const ProcessOptions& options, std::size_t quantity)
{
    auto chart = chartSettingOf<ChartOptions>(options);
    if (options.fixed && options.fixed->quantities[quantity]) {
        chart.target = options.fixed->quantities[quantity]->centre;
        chart.sigma = options.fixed->quantities[quantity]->sigma;
    }
    return chart;
}

/// How many points a pattern takes.
std::size_t patternLength(RunRules rules, int rule)
{
    constexpr std::array westernElectric{1, 3, 5, 8};
    constexpr std::array nelson{1, 9, 6, 14, 3, 5, 15, 8};
    const std::size_t place = std::size_t(std::max(1, rule)) - 1;
    if (rules == RunRules::WesternElectric && place < westernElectric.size())
        return std::size_t(westernElectric[place]);
    return rules == RunRules::Nelson && place < nelson.size() ? std::size_t(nelson[place]) : 1;
}

/// Signals at neighbouring points by the same rule are one.
std::vector<ProcessSignal> joinedSignals(const ChartStudy& study, std::size_t quantity)
{
    std::vector<ProcessSignal> joined;
    std::map<std::pair<ChartPart, int>, std::size_t> open; // its place among them
    for (const ChartSignal& signal : study.signalsFound) {
        const auto key = std::pair(signal.part, signal.rule);
        const auto before = open.find(key);
        if (before != open.end() && joined[before->second].last + 1 == signal.point &&
            (joined[before->second].rising == signal.rising || signal.rule > 1)) { // a side that is kept
            joined[before->second].last = signal.point;
            continue;
        }
        const std::size_t length =
            signal.part == ChartPart::Location ? patternLength(study.setting.rules, signal.rule) : 1;
        const std::size_t since =
            signal.since.value_or(signal.point + 1 - std::min(signal.point + 1, length));
        open[key] = joined.size();
        joined.push_back(
            {quantity, false, signal.part, signal.rule, signal.rising, signal.point, signal.point, since});
    }
    return joined;
}

template <typename Low, typename High, typename Signal>
PointBlocks blocksOf(std::size_t points, double origin, const Low& low, const High& high,
                     const Signal& signal)
{
    PointBlocks found;
    found.origin = origin;
    for (std::size_t first = 0; first < points; first += PointBlocks::size) {
        PointBlock block{float(low(first) - origin), float(high(first) - origin), false};
        for (std::size_t i = first; i < std::min(points, first + PointBlocks::size); ++i) {
            block.low = std::min(block.low, float(low(i) - origin));
            block.high = std::max(block.high, float(high(i) - origin));
            block.signal = block.signal || signal(i);
        }
        found.blocks.push_back(block);
    }
    return found;
}

PointBlocks blocksOf(const ChartStudy& study)
{
    const std::vector<ChartPoint>& points = study.points;
    const bool sums = study.setting.kind == ChartKind::Cusum;
    return blocksOf(
        points.size(), sums ? 0 : study.setting.centre,
        [&](std::size_t i) { return sums ? -points[i].lowerSum : points[i].value; },
        [&](std::size_t i) { return sums ? points[i].upperSum : points[i].value; },
        [&](std::size_t i) {
            const bool spread =
                i < study.spreadPoints.size() && study.spreadPoints[i] && study.spreadPoints[i]->rules != 0;
            return points[i].rules != 0 || spread;
        });
}

ProcessRows between(const ProcessValues& values, const ProcessRows& rows, qint64 first, qint64 last)
{
    ProcessRows found;
    std::copy_if(rows.begin(), rows.end(), std::back_inserter(found), [&](std::uint32_t row) {
        return values.numbers[row] >= first && values.numbers[row] <= last;
    });
    return found;
}

} // namespace

ProcessRows processRows(const ProcessValues& values, const ProcessFilter& filter)
{
    const auto station = nameAsked(values.stationNames, filter.station);
    const auto person = nameAsked(values.operatorNames, filter.operatorName);
    const auto batch = nameAsked(values.batchNames, filter.batch);
    ProcessRows rows;
    if (!station || !person || !batch)
        return rows;
    const qint64 from =
        filter.from.isValid() ? filter.from.toMSecsSinceEpoch() : std::numeric_limits<qint64>::min();
    const qint64 to =
        filter.to.isValid() ? filter.to.toMSecsSinceEpoch() : std::numeric_limits<qint64>::max();
    const auto is = [](std::uint32_t asked, std::uint32_t own) { return asked == anyName || asked == own; };
    rows.reserve(values.size());
    for (std::uint32_t row = 0; row < values.size(); ++row)
        if (is(*station, values.stations[row]) && is(*person, values.operators[row]) &&
            is(*batch, values.batches[row]) && values.times_ms[row] >= from && values.times_ms[row] < to)
            rows.push_back(row);
    const auto earlier = [&values](std::uint32_t a, std::uint32_t b) {
        return std::pair(values.times_ms[a], values.numbers[a]) <
               std::pair(values.times_ms[b], values.numbers[b]);
    };
    if (!std::is_sorted(rows.begin(), rows.end(), earlier))
        std::sort(rows.begin(), rows.end(), earlier);
    return rows;
}

std::uint32_t QuantityChart::row(std::size_t point) const
{
    return rows[std::min(rows.size(), (point + 1) * std::size_t(size)) - 1];
}

Expected<QuantityChart> drawQuantity(const ProcessValues& values, const ProcessRows& rows,
                                     std::size_t quantity, const ProcessOptions& options)
{
    if (values.unitsDiffer)
        return unitsThatDiffer();
    QuantityChart chart;
    chart.quantity = quantity;
    chart.size = std::max(1, options.size());
    DeterminedRows found = determinedRows(values, rows, quantity);
    chart.undetermined = rows.size() - found.rows.size();
    chart.rows = std::move(found.rows);
    ASSIGN_OR_RETURN(const SubgroupLayout layout,
                     SubgroupLayout::consecutive(found.values.size(), std::size_t(chart.size)));
    ASSIGN_OR_RETURN(const Subgroups groups, Subgroups::of(layout, found.values));
    ASSIGN_OR_RETURN(chart.study, studyChart(groups, chartOptionsOf(options, quantity)));
    chart.signalsFound = joinedSignals(chart.study, quantity);
    chart.blocks = blocksOf(chart.study);
    return chart;
}

Expected<FixedLimits> fixLimits(const ProcessValues& values, const ProcessRows& rows, qint64 first,
                                qint64 last, const ProcessOptions& options)
{
    if (values.unitsDiffer)
        return unitsThatDiffer();
    ProcessOptions phaseOne = options;
    phaseOne.fixed.reset();
    if (options.kind == ProcessKind::Hotelling)
        phaseOne.kind = ProcessKind::Individuals;
    const ProcessRows chosen = between(values, rows, first, last);
    FixedLimits fixed;
    fixed.kind = options.kind;
    fixed.rules = options.rules;
    fixed.subgroup = options.size();
    fixed.first = first;
    fixed.last = last;
    fixed.count = qint64(chosen.size());
    std::optional<Error> why;
    for (std::size_t i = 0; i < fixed.quantities.size(); ++i) {
        const Expected<QuantityChart> chart = drawQuantity(values, chosen, i, phaseOne);
        if (chart)
            fixed.quantities[i] = {chart->study.setting.centre, chart->study.setting.sigma};
        else
            why = chart.error();
    }
    phaseOne.kind = ProcessKind::Hotelling;
    if (const Expected<JointChart> joint = drawJoint(values, chosen, phaseOne))
        fixed.joint = joint->reference;
    const bool any = std::ranges::any_of(fixed.quantities, [](const auto& one) { return one.has_value(); });
    if (!any && !fixed.joint)
        return tl::unexpected(*why);
    return fixed;
}

RunLengths processRunLengths(const ProcessOptions& options)
{
    if (options.kind == ProcessKind::Hotelling)
        return {RunLength{hotellingRunLength(3, options.falseAlarm, 0), 0},
                RunLength{hotellingRunLength(3, options.falseAlarm, 1), 0}};
    auto setting = chartSettingOf<ChartSetting>(options);
    setting.size = options.size();
    return runLengths(setting);
}

namespace {

/// The rows that determine all three, and their columns.
struct JointRows {
    ProcessRows rows;
    std::vector<std::vector<double>> columns = std::vector<std::vector<double>>(3);
};

JointRows jointRows(const ProcessValues& values, const ProcessRows& rows)
{
    JointRows found;
    found.rows.reserve(rows.size());
    for (const std::uint32_t row : rows) {
        if (!std::ranges::all_of(values.quantities,
                                 [row](const auto& column) { return std::isfinite(column[row]); }))
            continue;
        found.rows.push_back(row);
        for (std::size_t i = 0; i < found.columns.size(); ++i)
            found.columns[i].push_back(values.quantities[i][row]);
    }
    return found;
}

/// Against limits that were fixed: each point of phase 2.
Expected<void> drawFixed(JointChart& chart, const JointRows& found)
{
    ASSIGN_OR_RETURN(const HotellingChart fixed, HotellingChart::of(chart.reference));
    Eigen::VectorXd value(3);
    chart.points.reserve(found.rows.size());
    for (std::size_t i = 0; i < found.rows.size(); ++i) {
        for (std::size_t column = 0; column < found.columns.size(); ++column)
            value(Eigen::Index(column)) = found.columns[column][i];
        ASSIGN_OR_RETURN(const HotellingPoint point, fixed.at(value));
        chart.points.push_back(point);
    }
    return {};
}

void noteJointSignals(JointChart& chart)
{
    for (std::size_t i = 0; i < chart.points.size(); ++i) {
        if (!chart.points[i].signal())
            continue;
        const std::size_t quantity = std::size_t(chart.points[i].column);
        std::vector<ProcessSignal>& all = chart.signalsFound;
        if (!all.empty() && all.back().last + 1 == i && all.back().quantity == quantity)
            all.back().last = i;
        else
            all.push_back({quantity, true, ChartPart::Location, 1, true, i, i, i});
    }
}

} // namespace

Expected<JointChart> drawJoint(const ProcessValues& values, const ProcessRows& rows,
                               const ProcessOptions& options)
{
    if (values.unitsDiffer)
        return unitsThatDiffer();
    JointRows found = jointRows(values, rows);
    JointChart chart;
    chart.undetermined = rows.size() - found.rows.size();
    if (options.fixed && options.fixed->joint) {
        chart.reference = *options.fixed->joint;
        chart.reference.falseAlarm = options.falseAlarm;
        RETURN_IF_ERROR(drawFixed(chart, found));
    } else {
        ASSIGN_OR_RETURN(const SubgroupLayout layout, SubgroupLayout::consecutive(found.rows.size(), 1));
        ASSIGN_OR_RETURN(HotellingStudy study,
                         studyHotelling(layout, found.columns, {options.falseAlarm, {}}));
        chart.reference = std::move(study.reference);
        chart.points = std::move(study.points);
        chart.messages = std::move(study.messages);
    }
    chart.rows = std::move(found.rows);
    noteJointSignals(chart);
    chart.blocks = blocksOf(
        chart.points.size(), 0, [&](std::size_t i) { return chart.points[i].tSquared; },
        [&](std::size_t i) { return chart.points[i].tSquared; },
        [&](std::size_t i) { return chart.points[i].signal(); });
    return chart;
}

} // namespace gripscope
