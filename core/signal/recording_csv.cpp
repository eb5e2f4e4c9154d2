// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/signal/recording_csv.h"

#include "core/signal/csv_line_reader.h"
#include "core/signal/measuring_chain_csv.h"
#include "core/words.h"

#include <QFile>
#include <QFileInfo>

#include <algorithm>
#include <cmath>
#include <limits>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

constexpr std::string_view formatKey = "gripscope-recording";

/// Reads one text: metadata, header, rows; made for one use.
class RecordingParser {
public:
    RecordingParser(const QByteArray& text, const QString& name, const CsvReadOptions& options)
        : m_lines(text, name), m_options(options)
    {
        // A row of numbers has some twenty bytes; a guess too low costs a copy only.
        m_expectedRows = static_cast<std::size_t>(text.size()) / 24;
    }

    Expected<Recording> parse();

private:
    Expected<void> readComment(std::string_view line);
    Expected<void> readSetting(std::string_view key, std::string_view value);
    Expected<void> readHeader(std::string_view line);
    Expected<std::size_t> findColumn(const QString& name) const;
    Expected<void> readRow(std::string_view line);
    Expected<double> number(std::size_t column) const;
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
    std::size_t m_force = 0, m_position = 0;
    std::optional<std::size_t> m_time, m_sequence, m_status;
};

Expected<Recording> RecordingParser::parse()
{
    while (const std::optional<std::string_view> line = m_lines.next()) {
        if (!isUtf8(*line))
            return m_lines.bad(1, Words::tr("bytes that are not UTF-8: ") + quoted(*line),
                               Words::tr("expected a text file in UTF-8"));
        Expected<void> done;
        if (trimmed(*line).front() == '#')
            done = readComment(trimmed(*line));
        else if (!m_hasHeader)
            done = readHeader(*line);
        else
            done = readRow(*line);
        if (!done)
            return tl::unexpected<Error>(done.error());
    }
    if (!m_hasHeader)
        return m_lines.bad(1, Words::tr("found no header line"),
                           Words::tr("expected column names such as \"time_s,force,position\""));
    if (m_recording.force.empty())
        return m_lines.bad(1, Words::tr("found no rows behind the header"),
                           Words::tr("expected one row a sample"));
    if (Expected<void> done = settle(); !done)
        return tl::unexpected<Error>(done.error());
    return std::move(m_recording);
}

Expected<void> RecordingParser::readComment(std::string_view line)
{
    line = trimmed(line.substr(1));
    const std::size_t colon = line.find(':');
    if (colon == std::string_view::npos || colon == 0)
        return {}; // a remark, not a fact
    return readSetting(trimmed(line.substr(0, colon)), trimmed(line.substr(colon + 1)));
}

Expected<void> RecordingParser::readSetting(std::string_view key, std::string_view value)
{
    const auto text = [](std::string_view bytes) {
        return QString::fromUtf8(bytes.data(), static_cast<qsizetype>(bytes.size()));
    };
    if (key == formatKey) {
        if (value != "1")
            return m_lines.bad(1, Words::tr("found a recording of version ") + quoted(value),
                               Words::tr("expected version 1"));
    } else if (key == "sample_time_s") {
        const std::optional<double> sampleTime = parseNumber(value);
        if (!sampleTime || !(*sampleTime > 0))
            return m_lines.bad(1, Words::tr("found the sample time ") + quoted(value),
                               Words::tr("expected seconds above 0"));
        m_recording.sampleTime_s = *sampleTime;
    } else if (key == "force_lag_s") {
        const std::optional<double> lag = parseNumber(value);
        if (!lag)
            return m_lines.bad(1, Words::tr("found the force lag ") + quoted(value),
                               Words::tr("expected seconds"));
        m_recording.forceLag_s = *lag;
        if (*lag == 0)
            m_recording.provenance.insert(forceLagSourceKey(), u"stated"_s);
    } else if (key == "force_hold") {
        m_recording.hold = forceHoldFromString(text(value));
        if (!m_recording.hold)
            return m_lines.bad(1, Words::tr("found the force hold ") + quoted(value),
                               Words::tr("expected zoh or foh"));
    } else if (key == "force_unit") {
        m_recording.forceUnit = text(value);
    } else if (key == "position_unit") {
        m_recording.positionUnit = text(value);
    } else {
        switch (setMeasuringChain(m_recording.chain, key, value)) {
        case ChainSetting::Taken:
            break;
        case ChainSetting::NoSuchKey:
            m_recording.provenance.insert(text(key), text(value));
            break;
        case ChainSetting::BadValue:
            return m_lines.bad(1, Words::tr("found %1: %2").arg(text(key), quoted(value)),
                               measuringChainExpectation(key));
        }
    }
    return {};
}

Expected<std::size_t> RecordingParser::findColumn(const QString& name) const
{
    const qsizetype at = m_columns.indexOf(name);
    if (at < 0)
        return m_lines.bad(1, Words::tr("found no column \"%1\"").arg(name),
                           Words::tr("expected one of the columns there are: ") + m_columns.join(u", "_s));
    if (m_columns.count(name) > 1)
        return m_lines.bad(static_cast<std::size_t>(m_columns.lastIndexOf(name)) + 1,
                           Words::tr("found the column \"%1\" twice").arg(name),
                           Words::tr("expected each column once"));
    return static_cast<std::size_t>(at);
}

Expected<void> RecordingParser::readHeader(std::string_view line)
{
    if (!splitCsvLine(line, m_fields, m_unquoted))
        return m_lines.bad(1, Words::tr("found a quote that is not closed"),
                           Words::tr("expected column names"));
    for (const std::string_view field : m_fields)
        m_columns << QString::fromUtf8(field.data(), static_cast<qsizetype>(field.size()));
    m_hasHeader = true;

    const Expected<std::size_t> force =
        findColumn(m_options.forceColumn.isEmpty() ? u"force"_s : m_options.forceColumn);
    if (!force)
        return tl::unexpected<Error>(force.error());
    const Expected<std::size_t> position =
        findColumn(m_options.positionColumn.isEmpty() ? u"position"_s : m_options.positionColumn);
    if (!position)
        return tl::unexpected<Error>(position.error());
    m_force = *force;
    m_position = *position;
    const auto optional = [this](const QString& name, std::optional<std::size_t>& column) -> Expected<void> {
        if (!m_columns.contains(name))
            return {};
        const Expected<std::size_t> found = findColumn(name);
        if (!found)
            return tl::unexpected<Error>(found.error());
        column = *found;
        return {};
    };
    for (const auto& [name, column] : {std::pair{u"time_s"_s, &m_time}, std::pair{u"sequence"_s, &m_sequence},
                                       std::pair{u"status"_s, &m_status}}) {
        if (const Expected<void> done = optional(name, *column); !done)
            return done;
    }
    m_recording.force.reserve(m_expectedRows);
    m_recording.position.reserve(m_expectedRows);
    m_recording.time_s.reserve(m_expectedRows);
    return {};
}

Expected<double> RecordingParser::number(std::size_t column) const
{
    const std::optional<double> value = parseNumber(m_fields[column]);
    if (!value)
        return m_lines.bad(column + 1, Words::tr("found %1").arg(quoted(m_fields[column])),
                           Words::tr("expected a finite number"));
    return *value;
}

Expected<void> RecordingParser::readRow(std::string_view line)
{
    if (!splitCsvLine(line, m_fields, m_unquoted))
        return m_lines.bad(1, Words::tr("found a quote that is not closed"),
                           Words::tr("expected a row of numbers"));
    if (m_fields.size() != static_cast<std::size_t>(m_columns.size()))
        return m_lines.bad(std::min(m_fields.size(), static_cast<std::size_t>(m_columns.size())),
                           Words::tr("found a row of %1 fields").arg(m_fields.size()),
                           Words::tr("expected %1, as in the header").arg(m_columns.size()));
    const Expected<double> force = number(m_force);
    if (!force)
        return tl::unexpected<Error>(force.error());
    const Expected<double> position = number(m_position);
    if (!position)
        return tl::unexpected<Error>(position.error());
    m_recording.force.push_back(*force);
    m_recording.position.push_back(*position);
    if (m_time) {
        const Expected<double> time = number(*m_time);
        if (!time)
            return tl::unexpected<Error>(time.error());
        if (!m_recording.time_s.empty() && !(*time > m_recording.time_s.back()))
            return m_lines.bad(*m_time + 1, Words::tr("found the time ") + quoted(m_fields[*m_time]),
                               Words::tr("expected a time later than the row before"));
        m_recording.time_s.push_back(*time);
    }
    if (m_sequence) {
        const auto value = parseCount(m_fields[*m_sequence], std::numeric_limits<std::uint64_t>::max());
        if (!value)
            return m_lines.bad(*m_sequence + 1, Words::tr("found %1").arg(quoted(m_fields[*m_sequence])),
                               Words::tr("expected a whole number from 0 up"));
        m_recording.sequence.push_back(*value);
    }
    if (m_status) {
        const auto value = parseCount(m_fields[*m_status], std::numeric_limits<std::uint16_t>::max());
        if (!value)
            return m_lines.bad(*m_status + 1, Words::tr("found %1").arg(quoted(m_fields[*m_status])),
                               Words::tr("expected a whole number from 0 to 65535"));
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
    if (m_recording.forceUnit.isEmpty())
        m_recording.forceUnit = u"1"_s;
    if (m_recording.positionUnit.isEmpty())
        m_recording.positionUnit = u"1"_s;
    return settleSampleTime();
}

Expected<void> RecordingParser::settleSampleTime()
{
    if (m_options.sampleTime_s) {
        if (!std::isfinite(*m_options.sampleTime_s) || !(*m_options.sampleTime_s > 0))
            return failure(ErrorCode::Usage, {Words::tr("the sample time must be above 0 s")});
        m_recording.sampleTime_s = *m_options.sampleTime_s;
    }
    std::vector<double>& time = m_recording.time_s;
    if (!m_time) {
        if (!(m_recording.sampleTime_s > 0))
            return m_lines.bad(1, Words::tr("found neither a time_s column nor \"# sample_time_s:\""),
                               Words::tr("expected one of them, or the sample time as an option"));
        time.resize(m_recording.size());
        for (std::size_t i = 0; i < time.size(); ++i)
            time[i] = static_cast<double>(i) * m_recording.sampleTime_s;
        return {};
    }
    if (time.size() < 2) {
        if (!(m_recording.sampleTime_s > 0))
            return m_lines.bad(1, Words::tr("found one row only"),
                               Words::tr("expected a second one, to tell the sample time"));
        return {};
    }
    std::vector<double> steps(time.size() - 1);
    for (std::size_t i = 0; i < steps.size(); ++i)
        steps[i] = time[i + 1] - time[i];
    const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
    std::nth_element(steps.begin(), middle, steps.end());
    if (!(m_recording.sampleTime_s > 0)) {
        m_recording.sampleTime_s = *middle;
        m_recording.provenance.insert(u"sample_time_source"_s, Words::tr("median step of time_s"));
    } else if (*middle < 0.5 * m_recording.sampleTime_s) {
        // Lost samples make steps longer, never shorter.
        return m_lines.bad(
            *m_time + 1, Words::tr("found steps of %1 s in time_s").arg(*middle),
            Words::tr("expected steps of the sample time, %1 s").arg(m_recording.sampleTime_s));
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
    if (QFileInfo(file).isDir())
        return failure(ErrorCode::FileUnreadable, {file, Words::tr("it is a folder")});
    QFile input(file);
    if (!input.open(QIODevice::ReadOnly))
        return failure(ErrorCode::FileUnreadable, {file, input.errorString()});
    const QByteArray text = input.readAll();
    if (input.error() != QFileDevice::NoError)
        return failure(ErrorCode::FileUnreadable, {file, input.errorString()});
    return parseRecordingCsv(text, file, options);
}

} // namespace gripscope
