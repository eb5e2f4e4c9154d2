// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/signal/recording/recording_csv.h"

#include "core/base/bounded_file.h"
#include "core/base/csv.h"
#include "core/base/words.h"
#include "core/signal/recording/measuring_chain_csv.h"
#include "core/signal/recording/recording_limits.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

constexpr std::string_view formatKey = "gripscope-recording";
/// A line is read whole: a fact in words is the longest there is.
constexpr std::size_t longestLine = 65'536;

/// Reads one text: metadata, header, rows; made for one use.
class RecordingParser {
public:
    RecordingParser(const QByteArray& text, const QString& name, const CsvReadOptions& options)
        : m_lines(text, name), m_options(options), m_decimalMark(options.format.decimalMark)
    {
        // A row of numbers has some twenty bytes; a guess too low costs a copy only.
        m_expectedRows = std::min(static_cast<std::size_t>(text.size()) / 24, mostSamples);
    }

    Expected<Recording> parse();

private:
    Expected<void> readComment(std::string_view line);
    Expected<void> readSetting(const QString& name, std::string_view key, std::string_view value);
    Expected<void> addFact(const QString& name, std::string_view value);
    [[nodiscard]] tl::unexpected<Error> longLine(std::size_t bytes, std::string_view line) const;
    [[nodiscard]] tl::unexpected<Error> tooManyFacts() const;
    Expected<void> readHeader(std::string_view line);
    [[nodiscard]] bool splitHeader(std::string_view line);
    [[nodiscard]] bool hasColumns(const QStringList& names) const;
    [[nodiscard]] QString forceName() const;
    [[nodiscard]] QString positionName() const;
    Expected<std::size_t> findColumn(const QString& name) const;
    Expected<void> findColumnsByName();
    Expected<void> takeColumns(const CsvColumns& columns);
    Expected<void> readRow(std::string_view line);
    Expected<void> splitRow(std::string_view line);
    Expected<double> number(std::size_t column);
    Expected<void> settle();
    Expected<void> settleSampleTime();

    CsvLineReader m_lines;
    CsvReadOptions m_options;
    Recording m_recording;
    std::size_t m_expectedRows = 0;
    std::vector<std::string_view> m_fields;
    std::vector<QByteArray> m_unquoted;
    QStringList m_columns;
    bool m_hasHeader = false;
    std::size_t m_linesBelow = 0; ///< the header, so far
    char m_delimiter = ',';
    char m_decimalMark = 0; ///< not known yet
    std::size_t m_force = 0, m_position = 0;
    std::optional<std::size_t> m_time, m_sequence, m_status;
};

Expected<Recording> RecordingParser::parse()
{
    if (!(m_options.timeUnit_s >= shortestTimeUnit_s && m_options.timeUnit_s <= longestTimeUnit_s))
        return failure(ErrorCode::Usage, {Words::say("the unit of time must have from %1 to %2 seconds")
                                              .arg(shortestTimeUnit_s)
                                              .arg(longestTimeUnit_s)});
    while (const std::optional<std::string_view> line = m_lines.next()) {
        if (m_lines.lineNumber() <= m_options.format.skippedLines)
            continue;
        if (line->size() > longestLine)
            return longLine(line->size(), *line);
        if (!isUtf8(*line))
            return m_lines.bad(1, Words::say("bytes that are not UTF-8: ") + quoted(*line),
                               Words::say("expected a text file in UTF-8"));
        Expected<void> done;
        if (trimmed(*line).front() == '#')
            done = readComment(trimmed(*line));
        else if (!m_hasHeader)
            done = readHeader(*line);
        else if (m_linesBelow < m_options.format.linesBelow)
            ++m_linesBelow;
        else
            done = readRow(*line);
        if (!done)
            return tl::unexpected<Error>(done.error());
    }
    if (!m_hasHeader)
        return m_lines.bad(1, Words::say("found no header line"),
                           Words::say("expected column names such as \"time_s,force,position\""));
    if (m_recording.force.empty())
        return m_lines.bad(1, Words::say("found no rows behind the header"),
                           Words::say("expected one row a sample"));
    RETURN_IF_ERROR(settle());
    if (m_recording.provenance.size() > mostFacts) // with those that reading it added
        return tooManyFacts();
    return std::move(m_recording);
}

tl::unexpected<Error> RecordingParser::longLine(std::size_t bytes, std::string_view line) const
{
    return m_lines.bad(1, Words::say("found a line of %1 bytes: %2").arg(bytes).arg(quoted(line)),
                       Words::say("expected at most %1 bytes a line").arg(longestLine));
}

tl::unexpected<Error> RecordingParser::tooManyFacts() const
{
    return m_lines.bad(1, Words::say("found more than %1 facts").arg(mostFacts),
                       Words::say("expected the rows"));
}

Expected<void> RecordingParser::readComment(std::string_view line)
{
    line = trimmed(line.substr(1));
    const std::size_t colon = line.find(':');
    if (colon == std::string_view::npos || colon == 0)
        return {}; // a remark, not a fact
    const QString name = factText(line.substr(0, colon));
    if (name.isEmpty())
        return {};
    // As it would be written, so that it reads the same the next time.
    const QByteArray key = name.toUtf8();
    const QByteArray value = factText(line.substr(colon + 1)).toUtf8();
    const std::size_t bytes =
        static_cast<std::size_t>(key.size()) + static_cast<std::size_t>(value.size()) + 4;
    if (bytes > longestLine)
        return longLine(bytes, line);
    return readSetting(name, {key.constData(), static_cast<std::size_t>(key.size())},
                       {value.constData(), static_cast<std::size_t>(value.size())});
}

Expected<void> RecordingParser::addFact(const QString& name, std::string_view value)
{
    if (m_recording.provenance.size() >= mostFacts && !m_recording.provenance.contains(name))
        return tooManyFacts();
    m_recording.provenance.insert(name, factText(value));
    return {};
}

Expected<void> RecordingParser::readSetting(const QString& name, std::string_view key, std::string_view value)
{
    if (key == formatKey) {
        if (value != "1")
            return m_lines.bad(1, Words::say("found a recording of version ") + quoted(value),
                               Words::say("expected version 1"));
    } else if (key == "sample_time_s") {
        const std::optional<double> sampleTime = parseNumber(value);
        if (!sampleTime || !isSampleTime(*sampleTime))
            return m_lines.bad(1, Words::say("found the sample time ") + quoted(value),
                               Words::say("expected %1").arg(sampleTimeExpectation()));
        m_recording.sampleTime_s = *sampleTime;
    } else if (key == "force_lag_s") {
        const std::optional<double> lag = parseNumber(value);
        if (!lag || std::abs(*lag) > longestForceLag_s)
            return m_lines.bad(1, Words::say("found the force lag ") + quoted(value),
                               Words::say("expected seconds from -%1 to %1").arg(longestForceLag_s));
        m_recording.forceLag_s = *lag;
        if (*lag == 0)
            m_recording.provenance.insert(forceLagSourceKey(), u"stated"_s);
    } else if (key == "force_hold") {
        m_recording.hold = forceHoldFromString(factText(value));
        if (!m_recording.hold)
            return m_lines.bad(1, Words::say("found the force hold ") + quoted(value),
                               Words::say("expected zoh or foh"));
    } else if (key == "force_unit") {
        m_recording.forceUnit = factText(value);
    } else if (key == "position_unit") {
        m_recording.positionUnit = factText(value);
    } else {
        switch (setMeasuringChain(m_recording.chain, key, value)) {
        case ChainSetting::Taken:
            break;
        case ChainSetting::NoSuchKey:
            return addFact(name, value);
        case ChainSetting::BadValue:
            return m_lines.bad(1, Words::say("found %1: %2").arg(name, quoted(value)),
                               measuringChainExpectation(key));
        }
    }
    return {};
}

Expected<std::size_t> RecordingParser::findColumn(const QString& name) const
{
    const qsizetype at = m_columns.indexOf(name);
    if (at < 0)
        return m_lines.bad(1, Words::say("found no column \"%1\"").arg(name),
                           Words::say("expected one of the columns there are: ") + m_columns.join(u", "_s));
    if (m_columns.count(name) > 1)
        return m_lines.bad(static_cast<std::size_t>(m_columns.lastIndexOf(name)) + 1,
                           Words::say("found the column \"%1\" twice").arg(name),
                           Words::say("expected each column once"));
    return static_cast<std::size_t>(at);
}

QString RecordingParser::forceName() const
{
    return m_options.forceColumn.isEmpty() ? u"force"_s : m_options.forceColumn;
}

QString RecordingParser::positionName() const
{
    return m_options.positionColumn.isEmpty() ? u"position"_s : m_options.positionColumn;
}

bool RecordingParser::hasColumns(const QStringList& names) const
{
    if (m_options.columns) {
        const std::size_t last = std::max(
            {m_options.columns->force, m_options.columns->position, m_options.columns->time.value_or(0)});
        return last < static_cast<std::size_t>(names.size());
    }
    return names.contains(forceName()) && names.contains(positionName());
}

/// By the delimiter that was given, else by the first of those in use that parts off the columns that are
/// asked for, else by that which makes most. False: a quote is not closed.
bool RecordingParser::splitHeader(std::string_view line)
{
    const CsvFormat& format = m_options.format;
    for (const char delimiter : {',', ';', '\t'}) {
        if ((format.delimiter != 0 && delimiter != format.delimiter) ||
            !splitCsvLine(line, m_fields, m_unquoted, delimiter))
            continue;
        QStringList names;
        for (const std::string_view field : m_fields)
            names << (format.header ? QString::fromUtf8(field.data(), static_cast<qsizetype>(field.size()))
                                    : QString::number(names.size() + 1));
        const bool found = hasColumns(names);
        if (found || names.size() > m_columns.size()) {
            m_columns = names;
            m_delimiter = delimiter;
        }
        if (found)
            break;
    }
    return !m_columns.isEmpty();
}

Expected<void> RecordingParser::readHeader(std::string_view line)
{
    if (!splitHeader(line))
        return m_lines.bad(1, Words::say("found a quote that is not closed"),
                           Words::say("expected column names"));
    m_hasHeader = true;
    RETURN_IF_ERROR(m_options.columns ? takeColumns(*m_options.columns) : findColumnsByName());
    m_recording.force.reserve(m_expectedRows);
    m_recording.position.reserve(m_expectedRows);
    m_recording.time_s.reserve(m_expectedRows);
    return m_options.format.header ? Expected<void>() : readRow(line);
}

Expected<void> RecordingParser::takeColumns(const CsvColumns& columns)
{
    if (columns.force == columns.position || columns.time == columns.force ||
        columns.time == columns.position)
        return failure(ErrorCode::Usage,
                       {Words::say("force, position and time must be columns of their own")});
    const auto count = static_cast<std::size_t>(m_columns.size());
    const std::size_t last = std::max({columns.force, columns.position, columns.time.value_or(0)});
    if (last >= count)
        return m_lines.bad(count, Words::say("found %1 columns").arg(count),
                           Words::say("expected at least %1").arg(last + 1));
    m_force = columns.force;
    m_position = columns.position;
    m_time = columns.time;
    return {};
}

Expected<void> RecordingParser::findColumnsByName()
{
    ASSIGN_OR_RETURN(const std::size_t force, findColumn(forceName()));
    ASSIGN_OR_RETURN(const std::size_t position, findColumn(positionName()));
    m_force = force;
    m_position = position;
    const auto optional = [this](const QString& name, std::optional<std::size_t>& column) -> Expected<void> {
        if (!m_columns.contains(name))
            return {};
        ASSIGN_OR_RETURN(const std::size_t found, findColumn(name));
        column = found;
        return {};
    };
    if (!m_options.timeColumn.isEmpty()) {
        ASSIGN_OR_RETURN(const std::size_t time, findColumn(m_options.timeColumn));
        m_time = time;
    } else {
        RETURN_IF_ERROR(optional(u"time_s"_s, m_time));
    }
    RETURN_IF_ERROR(optional(u"sequence"_s, m_sequence));
    return optional(u"status"_s, m_status);
}

Expected<double> RecordingParser::number(std::size_t column)
{
    const std::string_view field = m_fields[column];
    if (m_decimalMark == 0)
        if (const std::size_t at = field.find_first_of(".,"); at != std::string_view::npos)
            m_decimalMark = field[at];
    const bool comma = m_decimalMark == ',';
    const std::optional<double> value = parseNumber(field, m_decimalMark);
    if (!value)
        return m_lines.bad(column + 1, Words::say("found %1").arg(quoted(field)),
                           comma ? Words::say("expected a finite number with a decimal comma")
                                 : Words::say("expected a finite number"));
    if (!isReading(*value))
        return m_lines.bad(
            column + 1, Words::say("found %1").arg(quoted(field)),
            Words::say("expected a number from %1 to %2").arg(-largestReading).arg(largestReading));
    return *value;
}

Expected<void> RecordingParser::splitRow(std::string_view line)
{
    if (!splitCsvLine(line, m_fields, m_unquoted, m_delimiter))
        return m_lines.bad(1, Words::say("found a quote that is not closed"),
                           Words::say("expected a row of numbers"));
    const auto columns = static_cast<std::size_t>(m_columns.size());
    // Some programs end each row with one more delimiter.
    if (m_options.columns && m_fields.size() == columns + 1 && m_fields.back().empty())
        m_fields.pop_back();
    if (m_fields.size() != columns)
        return m_lines.bad(std::min(m_fields.size(), columns),
                           Words::say("found a row of %1 fields").arg(m_fields.size()),
                           Words::say("expected %1, as in the header").arg(m_columns.size()));
    return {};
}

Expected<void> RecordingParser::readRow(std::string_view line)
{
    RETURN_IF_ERROR(splitRow(line));
    if (m_recording.size() >= mostSamples)
        return m_lines.bad(1, Words::say("found more than %1 samples").arg(mostSamples),
                           Words::say("expected fewer: cut the recording into parts"));
    ASSIGN_OR_RETURN(const double force, number(m_force));
    ASSIGN_OR_RETURN(const double position, number(m_position));
    m_recording.force.push_back(force);
    m_recording.position.push_back(position);
    if (m_time) {
        ASSIGN_OR_RETURN(const double units, number(*m_time));
        const double time = units * m_options.timeUnit_s;
        if (!isReading(time))
            return m_lines.bad(
                *m_time + 1, Words::say("found the time ") + quoted(m_fields[*m_time]),
                Words::say("expected a number from %1 to %2").arg(-largestReading).arg(largestReading));
        if (!m_recording.time_s.empty() && !(time > m_recording.time_s.back()))
            return m_lines.bad(*m_time + 1, Words::say("found the time ") + quoted(m_fields[*m_time]),
                               Words::say("expected a time later than the row before"));
        m_recording.time_s.push_back(time);
    }
    if (m_sequence) {
        const auto value = parseCount(m_fields[*m_sequence], std::numeric_limits<std::uint64_t>::max());
        if (!value)
            return m_lines.bad(*m_sequence + 1, Words::say("found %1").arg(quoted(m_fields[*m_sequence])),
                               Words::say("expected a whole number from 0 up"));
        m_recording.sequence.push_back(*value);
    }
    if (m_status) {
        const auto value = parseCount(m_fields[*m_status], std::numeric_limits<std::uint16_t>::max());
        if (!value)
            return m_lines.bad(*m_status + 1, Words::say("found %1").arg(quoted(m_fields[*m_status])),
                               Words::say("expected a whole number from 0 to 65535"));
        m_recording.status.push_back(static_cast<std::uint16_t>(*value));
    }
    return {};
}

Expected<void> RecordingParser::settle()
{
    if (!m_options.forceUnit.isEmpty())
        m_recording.forceUnit = m_options.forceUnit;
    if (!m_options.positionUnit.isEmpty())
        m_recording.positionUnit = m_options.positionUnit;
    if (m_options.hold)
        m_recording.hold = m_options.hold;
    if (m_recording.forceUnit.isEmpty())
        m_recording.forceUnit = u"1"_s;
    if (m_recording.positionUnit.isEmpty())
        m_recording.positionUnit = u"1"_s;
    return settleSampleTime();
}

Expected<void> RecordingParser::settleSampleTime()
{
    if (m_options.sampleTime_s) {
        if (!isSampleTime(*m_options.sampleTime_s))
            return failure(ErrorCode::Usage,
                           {Words::say("the sample time must be %1").arg(sampleTimeExpectation())});
        m_recording.sampleTime_s = *m_options.sampleTime_s;
    }
    std::vector<double>& time = m_recording.time_s;
    if (!m_time) {
        if (!(m_recording.sampleTime_s > 0))
            return m_lines.bad(1, Words::say("found neither a time_s column nor \"# sample_time_s:\""),
                               Words::say("expected one of them, or the sample time as an option"));
        time.resize(m_recording.size());
        for (std::size_t i = 0; i < time.size(); ++i)
            time[i] = static_cast<double>(i) * m_recording.sampleTime_s;
        return {};
    }
    if (time.size() < 2) {
        if (!(m_recording.sampleTime_s > 0))
            return m_lines.bad(1, Words::say("found one row only"),
                               Words::say("expected a second one, to tell the sample time"));
        return {};
    }
    const QString timeName = m_columns[static_cast<qsizetype>(*m_time)].left(40);
    std::vector<double> steps(time.size() - 1);
    for (std::size_t i = 0; i < steps.size(); ++i)
        steps[i] = time[i + 1] - time[i];
    const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
    std::nth_element(steps.begin(), middle, steps.end());
    if (!(m_recording.sampleTime_s > 0)) {
        if (!isSampleTime(*middle))
            return m_lines.bad(*m_time + 1,
                               Words::say("found steps of %1 s in %2").arg(*middle).arg(timeName),
                               Words::say("expected %1").arg(sampleTimeExpectation()));
        m_recording.sampleTime_s = *middle;
        m_recording.provenance.insert(u"sample_time_source"_s, timeName == u"time_s"
                                                                   ? u"median step of time_s"_s
                                                                   : u"median step of the times"_s);
    } else if (*middle < 0.5 * m_recording.sampleTime_s) {
        // Lost samples make steps longer, never shorter.
        return m_lines.bad(
            *m_time + 1, Words::say("found steps of %1 s in %2").arg(*middle).arg(timeName),
            Words::say("expected steps of the sample time, %1 s").arg(m_recording.sampleTime_s));
    }
    return {};
}

} // namespace

Expected<Recording> parseRecordingCsv(const QByteArray& text, const QString& name,
                                      const CsvReadOptions& options)
{
    return RecordingParser(text, name, options).parse();
}

Expected<Recording> readRecordingCsv(const QString& file, const CsvReadOptions& options)
{
    ASSIGN_OR_RETURN(const QByteArray text, readBounded(file, largestRecordingFile));
    return parseRecordingCsv(text, file, options);
}

} // namespace gripscope
