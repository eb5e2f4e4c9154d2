// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/quality/table/study_table.h"

#include "core/base/csv.h"
#include "core/base/words.h"

#include <QHash>

#include <algorithm>
#include <cstdint>
#include <utility>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

constexpr int mostDigits = 18; // of an std::int64_t, with room for a difference

/// mantissa / 10^decimals.
struct WrittenDecimal {
    std::int64_t mantissa = 0;
    int digits = 0, decimals = 0;
};

std::optional<WrittenDecimal> writtenDecimal(std::string_view text)
{
    WrittenDecimal number;
    const bool negative = !text.empty() && text.front() == '-';
    if (!text.empty() && (negative || text.front() == '+'))
        text.remove_prefix(1);
    bool isFraction = false;
    for (const char c : text) {
        if (c == '.' && !isFraction) {
            isFraction = true;
            continue;
        }
        if (c < '0' || c > '9' || ++number.digits > mostDigits)
            return {};
        number.mantissa = 10 * number.mantissa + (c - '0');
        number.decimals += isFraction;
    }
    if (number.digits == 0)
        return {};
    number.mantissa = negative ? -number.mantissa : number.mantissa;
    return number;
}

/// False where more digits than can be held would be needed.
bool extendDecimals(WrittenDecimal& number, int decimals)
{
    for (; number.decimals < decimals; ++number.decimals) {
        if (++number.digits > mostDigits)
            return false;
        number.mantissa *= 10;
    }
    return true;
}

} // namespace

Expected<StudyTable> StudyTable::parse(const QByteArray& text, const QString& name)
{
    StudyTable table;
    table.m_name = name;
    ASSIGN_OR_RETURN(table.m_lines, splitTable(text, name));
    const qsizetype wide = table.m_lines.front().fields.size();
    for (const TableLine& line : table.m_lines)
        if (line.fields.size() != wide)
            return TablePlace{name, line.number, std::min(line.fields.size(), wide) + 1}.error(
                u"%1 fields"_s.arg(line.fields.size()), Words::say("%1, as in the header").arg(wide));
    return table;
}

Expected<StudyTable> StudyTable::read(const QString& file)
{
    ASSIGN_OR_RETURN(const QByteArray text, readTableFile(file));
    return parse(text, file);
}

StudyTable StudyTable::of(const QString& name, const QStringList& columns,
                          const std::vector<QStringList>& rows)
{
    StudyTable table;
    table.m_name = name;
    table.m_lines.push_back({1, columns});
    int number = 1;
    for (const QStringList& row : rows)
        table.m_lines.push_back({++number, row});
    return table;
}

Expected<qsizetype> StudyTable::place(const QString& column) const
{
    ASSIGN_OR_RETURN(const auto found, findTableColumns(m_lines, {column}, m_name));
    return found.front();
}

Expected<StudyLabels> StudyTable::labels(const QString& column, EmptyCells empty) const
{
    ASSIGN_OR_RETURN(const qsizetype at, place(column));
    StudyLabels labels;
    QHash<QString, int> known;
    for (std::size_t i = 1; i < m_lines.size(); ++i) {
        const QString& cell = m_lines[i].fields[at];
        if (cell.isEmpty() && empty == EmptyCells::Missing) {
            labels.index.push_back(-1);
            continue;
        }
        if (cell.isEmpty())
            return TablePlace{m_name, m_lines[i].number, at + 1}.error(u"\"\""_s,
                                                                       Words::say("a name or a number"));
        const auto place = known.constFind(cell);
        if (place != known.cend()) {
            labels.index.push_back(*place);
            continue;
        }
        known.insert(cell, int(labels.names.size()));
        labels.index.push_back(int(labels.names.size()));
        labels.names.append(cell);
    }
    return labels;
}

Expected<std::vector<double>> StudyTable::numbers(const QString& column) const
{
    ASSIGN_OR_RETURN(const qsizetype at, place(column));
    std::vector<double> values;
    values.reserve(rows());
    for (std::size_t i = 1; i < m_lines.size(); ++i) {
        const QString& cell = m_lines[i].fields[at];
        const QByteArray text = cell.toUtf8();
        const std::optional<double> value =
            parseNumber(std::string_view(text.data(), std::size_t(text.size())));
        if (!value)
            return TablePlace{m_name, m_lines[i].number, at + 1}.error(u"\"%1\""_s.arg(cell),
                                                                       Words::say("a finite number"));
        values.push_back(*value);
    }
    return values;
}

Expected<OffsetColumn> StudyTable::offsets(const QString& column) const
{
    ASSIGN_OR_RETURN(const qsizetype at, place(column));
    ASSIGN_OR_RETURN(std::vector<double> values, numbers(column));
    OffsetColumn found{values.front(), std::move(values)};
    const QByteArray first = m_lines[1].fields[at].toLatin1().trimmed();
    for (std::size_t i = 0; i < found.offsets.size(); ++i) {
        const QByteArray text = m_lines[i + 1].fields[at].toLatin1().trimmed();
        const std::optional<double> exact = decimalDifference({text.data(), std::size_t(text.size())},
                                                              {first.data(), std::size_t(first.size())});
        found.offsets[i] = exact ? *exact : found.offsets[i] - found.origin;
    }
    return found;
}

std::optional<double> decimalDifference(std::string_view a, std::string_view b)
{
    std::optional<WrittenDecimal> left = writtenDecimal(a), right = writtenDecimal(b);
    if (!left || !right)
        return {};
    const int decimals = std::max(left->decimals, right->decimals);
    if (!extendDecimals(*left, decimals) || !extendDecimals(*right, decimals))
        return {};
    double unit = 1; // a power of ten up to 10^18 is a double without rounding
    for (int i = 0; i < decimals; ++i)
        unit *= 10;
    return double(left->mantissa - right->mantissa) / unit;
}

} // namespace gripscope
