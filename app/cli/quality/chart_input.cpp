// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/quality/chart_input.h"

#include "app/cli/library/existing_library.h"
#include "app/cli/line/output.h"
#include "app/cli/options/shared_options.h"
#include "core/base/words.h"

#include <QTimeZone>

#include <algorithm>
#include <cmath>

namespace gripscope::cli {

using namespace Qt::StringLiterals;

namespace {

const QStringList narrowingOptions{u"gripper"_qs, u"station"_qs, u"operator"_qs, u"from"_qs, u"to"_qs};
const QStringList numberColumns{u"m"_qs, u"b"_qs, u"k"_qs, u"number"_qs};
const QStringList nameColumns{u"station"_qs, u"operator"_qs, u"batch"_qs};

/// Day `name` in local time, so many days later; not valid where it is not set.
Expected<QDateTime> dayOf(const CommandLine& line, const QString& name, int later)
{
    if (!line.isSet(name))
        return QDateTime();
    const QDate day = QDate::fromString(line.text(name), Qt::ISODate);
    if (!day.isValid())
        return failure(ErrorCode::Usage, {Words::say("--%1 is \"%2\"; a day such as 2024-05-31 was expected.")
                                              .arg(Finding(name))
                                              .arg(Finding(line.text(name)))});
    return day.addDays(later).startOfDay();
}

Expected<ProcessFilter> filterOf(const CommandLine& line)
{
    ProcessFilter filter;
    filter.station = line.text(u"station"_qs);
    filter.operatorName = line.text(u"operator"_qs);
    filter.batch = line.text(u"batch"_qs).trimmed();
    ASSIGN_OR_RETURN(filter.from, dayOf(line, u"from"_qs, 0));
    ASSIGN_OR_RETURN(filter.to, dayOf(line, u"to"_qs, 1));
    return filter;
}

double valueAt(const ProcessValues& values, std::uint32_t row, qsizetype column)
{
    return column < 3 ? values.quantities[std::size_t(column)][row] : double(values.numbers[row]);
}

} // namespace

void addChartTableOptions(CommandLine& line)
{
    addTableOptions(line);
    line.option(u"type"_qs, u"NAME"_qs,
                u"Of the library only inspections in which this type was recognised, in order of time, with "
                "the columns m, b, k, number, station, operator, batch."_qs);
    line.option(u"gripper"_qs, u"NAME"_qs, u"With --type: only of this gripper, as the history has it."_qs);
    line.option(u"station"_qs, u"NAME"_qs, u"With --type: only of this station."_qs);
    line.option(u"operator"_qs, u"NAME"_qs, u"With --type: only squeezed by this person."_qs);
    line.option(u"from"_qs, u"DAY"_qs, u"With --type: from this day on, as 2024-05-31."_qs);
    line.option(u"to"_qs, u"DAY"_qs, u"With --type: up to this day."_qs);
}

Expected<ChartInput> ChartInput::read(const CommandLine& line, const QStringList& values)
{
    if (line.isSet(u"type"_qs))
        return ofInspections(line, values);
    for (const QString& name : narrowingOptions)
        if (line.isSet(name))
            return failure(ErrorCode::Usage, {Words::say("--%1 goes with --type.").arg(Finding(name))});
    ChartInput input;
    ASSIGN_OR_RETURN(input.m_table, studyTable(line));
    return input;
}

Expected<ChartInput> ChartInput::ofInspections(const CommandLine& line, const QStringList& values)
{
    if (!line.files().isEmpty())
        return failure(
            ErrorCode::Usage,
            {Words::say("a table comes from TABLE.csv or from --library and --type, not from both")});
    ASSIGN_OR_RETURN(const ProcessFilter filter, filterOf(line));
    ASSIGN_OR_RETURN(const std::unique_ptr<Library> library, libraryFile(line).and_then(openExistingLibrary));
    ProcessQuery query;
    query.type = line.text(u"type"_qs);
    query.gripper = line.text(u"gripper"_qs);
    ChartInput input;
    ProcessPlace place;
    while (!place.through) {
        ASSIGN_OR_RETURN(place, library->processStretch(query, place, input.m_values));
    }
    if (input.m_values.unitsDiffer)
        return failure(ErrorCode::UnitsDiffer, {place.units, u"SI"_qs});
    input.m_rows = processRows(input.m_values, filter);
    const std::size_t before = input.m_rows.size();
    for (const QString& name : values)
        if (const qsizetype column = numberColumns.indexOf(name); column >= 0)
            std::erase_if(input.m_rows, [&](std::uint32_t row) {
                return !std::isfinite(valueAt(input.m_values, row, column));
            });
    if (before > input.m_rows.size())
        message(u"%1 inspections are left out: they do not determine %2."_qs.arg(before - input.m_rows.size())
                    .arg(values.join(u", "_qs)));
    if (input.m_rows.empty())
        return failure(ErrorCode::NotFound,
                       {u"an inspection of %1 that these options let through"_qs.arg(query.type)});
    return input;
}

std::size_t ChartInput::rows() const
{
    return m_table ? m_table->rows() : m_rows.size();
}

QStringList ChartInput::columns() const
{
    return m_table ? m_table->columns() : numberColumns + nameColumns;
}

Expected<std::vector<double>> ChartInput::numbers(const QString& column) const
{
    if (m_table)
        return m_table->numbers(column);
    const qsizetype place = numberColumns.indexOf(column);
    if (place < 0)
        return failure(ErrorCode::BadInput,
                       {Words::say("The column \"%1\"").arg(Finding(column)), Words::say("it is not there"),
                        Words::say("one of %1 was expected").arg(Finding(numberColumns.join(u", "_qs)))});
    std::vector<double> numbers;
    numbers.reserve(m_rows.size());
    for (const std::uint32_t row : m_rows)
        numbers.push_back(valueAt(m_values, row, place));
    return numbers;
}

Expected<SubgroupLayout> ChartInput::byColumn(const QString& column) const
{
    if (m_table) {
        ASSIGN_OR_RETURN(const StudyLabels labels, m_table->labels(column));
        return SubgroupLayout::labelled(labels.index, std::size_t(labels.names.size()));
    }
    const SharedColumn<std::uint32_t>& places = column == u"station"_qs    ? m_values.stations
                                                : column == u"operator"_qs ? m_values.operators
                                                                           : m_values.batches;
    // In the order of each label's first row.
    std::vector<int> seen, index;
    int labels = 0;
    index.reserve(m_rows.size());
    for (const std::uint32_t row : m_rows) {
        if (places[row] >= seen.size())
            seen.resize(places[row] + 1, -1);
        int& label = seen[places[row]];
        label = label < 0 ? labels++ : label;
        index.push_back(label);
    }
    return SubgroupLayout::labelled(index, std::size_t(labels));
}

Expected<SubgroupLayout> ChartInput::layout(const QString& text) const
{
    if (text.isEmpty())
        return SubgroupLayout::consecutive(rows(), 1);
    if (columns().contains(text) && (m_table || nameColumns.contains(text)))
        return byColumn(text);
    bool whole = false;
    const int size = text.toInt(&whole);
    if (!whole || size < 1)
        return failure(ErrorCode::Usage,
                       {Words::say("--subgroup is \"%1\"; a column of the table or a number "
                                   "of rows from 1 was expected.")
                            .arg(Finding(text))});
    return SubgroupLayout::consecutive(rows(), std::size_t(size));
}

} // namespace gripscope::cli
