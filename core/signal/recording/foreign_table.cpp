// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/signal/recording/foreign_table.h"

#include "core/base/bounded_file.h"
#include "core/base/csv.h"
#include "core/base/words.h"
#include "core/signal/recording/recording_limits.h"
#include "core/signal/recording/units.h"

#include <QCryptographicHash>
#include <QFile>
#include <QStringDecoder>

#include <algorithm>
#include <array>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

/// Of the beginning; a head longer than that is no head.
constexpr std::size_t mostHeadLines = 400;
constexpr std::size_t shownRows = 12;
constexpr qsizetype mostTableColumns = 1000;
constexpr qsizetype longestName = 80;
/// Rows in a row, from which on lines are the table and not its head.
constexpr std::size_t rowsToBelieve = 3;

struct HeadLine {
    std::size_t number = 0; ///< in the file, from 1
    std::string_view text;
};

/// Comments left out.
std::vector<HeadLine> headLines(const QByteArray& head)
{
    std::vector<HeadLine> lines;
    CsvLineReader reader(head, {});
    while (const std::optional<std::string_view> line = reader.next()) {
        if (trimmed(*line).front() != '#')
            lines.push_back({reader.lineNumber(), *line});
        if (lines.size() == mostHeadLines)
            return lines;
    }
    return lines;
}

QStringList fieldsOf(std::string_view line, char delimiter)
{
    std::vector<std::string_view> fields;
    std::vector<QByteArray> unquoted;
    QStringList texts;
    if (!splitCsvLine(line, fields, unquoted, delimiter))
        return texts;
    for (const std::string_view field : fields) {
        if (texts.size() == mostTableColumns)
            break;
        texts << factText(field.substr(0, 4 * longestName)).left(longestName);
    }
    return texts;
}

std::optional<double> numberIn(const QString& field, char decimalMark)
{
    const QByteArray bytes = field.toUtf8();
    return parseNumber({bytes.constData(), static_cast<std::size_t>(bytes.size())}, decimalMark);
}

bool isNumber(const QString& field, char decimalMark)
{
    return numberIn(field, decimalMark).has_value();
}

struct Lines {
    char delimiter = ',', decimalMark = '.';
    std::vector<QStringList> fields;
    std::vector<bool> isRow;   ///< two numbers at least
    std::size_t first = 0;     ///< row
    std::size_t rowsCount = 0; ///< from there on
};

Lines splitLines(const std::vector<HeadLine>& head, char delimiter, char decimalMark)
{
    Lines lines{delimiter, decimalMark, {}, {}, 0, 0};
    for (const HeadLine& line : head) {
        lines.fields.push_back(fieldsOf(line.text, delimiter));
        const QStringList& fields = lines.fields.back();
        lines.isRow.push_back(std::count_if(fields.begin(), fields.end(), [&](const QString& field) {
                                  return isNumber(field, decimalMark);
                              }) >= 2);
    }
    const std::size_t needed = std::min(rowsToBelieve, head.size());
    for (std::size_t i = 0; i < head.size(); ++i) {
        std::size_t run = 0;
        while (i + run < head.size() && lines.isRow[i + run] &&
               lines.fields[i + run].size() == lines.fields[i].size())
            ++run;
        const bool toTheEnd = run > 0 && i + run == head.size();
        if (run < needed && !toTheEnd) {
            i += std::max<std::size_t>(run, 1) - 1;
            continue;
        }
        lines.first = i;
        lines.rowsCount = run;
        break;
    }
    return lines;
}

/// Numbers in the rows: the way of reading that finds most is right.
std::size_t numbersIn(const Lines& lines)
{
    std::size_t count = 0;
    for (std::size_t i = lines.first; i < lines.first + lines.rowsCount; ++i) {
        const QStringList& fields = lines.fields[i];
        const bool whole = std::all_of(fields.begin(), fields.end(), [&](const QString& field) {
            return isNumber(field, lines.decimalMark);
        });
        // "0,5;1,2" has two numbers between commas too, and a field that is none.
        count += whole ? 2 : 1;
    }
    return count;
}

Lines mostNumbers(const std::vector<HeadLine>& head)
{
    Lines best;
    std::size_t most = 0;
    // A comma parts decimal commas only where nothing else parts: it comes last.
    for (const auto& [delimiter, mark] : {std::pair{';', '.'}, std::pair{';', ','}, std::pair{'\t', '.'},
                                          std::pair{'\t', ','}, std::pair{',', '.'}, std::pair{',', ','}}) {
        Lines lines = splitLines(head, delimiter, mark);
        if (const std::size_t count = numbersIn(lines); count > most) {
            most = count;
            best = std::move(lines);
        }
    }
    return best;
}

bool isNames(const QStringList& fields, qsizetype count)
{
    return fields.size() == count &&
           std::any_of(fields.begin(), fields.end(), [](const QString& f) { return !f.isEmpty(); }) &&
           std::none_of(fields.begin(), fields.end(),
                        [](const QString& f) { return isNumber(f, '.') || isNumber(f, ','); });
}

/// As other programs write it: µ by the Greek letter, in brackets or not.
QString plainUnit(QString unit)
{
    unit = unit.trimmed();
    if (unit.size() > 2 && (unit.startsWith(u'[') || unit.startsWith(u'(')) &&
        (unit.endsWith(u']') || unit.endsWith(u')')))
        unit = unit.mid(1, unit.size() - 2).trimmed();
    return unit;
}

bool isUnit(const QString& unit)
{
    return newtonsPer(unit) || metresPer(unit) || secondsPer(unit);
}

/// "Force (N)", "Kraft [N]", "Kraft / N", "F in N", "time_s", "mm".
QString unitOfName(const QString& name)
{
    const qsizetype open = std::max(name.lastIndexOf(u'['), name.lastIndexOf(u'('));
    if (open >= 0)
        if (const QString unit = plainUnit(name.mid(open)); isUnit(unit))
            return unit;
    const auto isAWord = [](const QString& unit) { return unit == u"in"; }; // u_in is no length in inches
    for (const QString& between : {u"/"_s, u" in "_s, u"_"_s, u" "_s})
        if (const qsizetype at = name.lastIndexOf(between); at >= 0)
            if (const QString unit = name.mid(at + between.size()).trimmed();
                isUnit(unit) && !(isAWord(unit) && between.trimmed() != u"/" && between != u" in "))
                return unit;
    return isUnit(name) && !isAWord(name) ? name : QString();
}

bool isUnits(const QStringList& fields)
{
    return std::any_of(fields.begin(), fields.end(), [](const QString& f) { return isUnit(plainUnit(f)); });
}

/// Where the names are and what is below them.
void findHeader(const std::vector<HeadLine>& head, const Lines& lines, CsvFormat& format)
{
    const qsizetype count = lines.fields[lines.first].size();
    const auto names = [&](std::size_t above) {
        return lines.first >= above && isNames(lines.fields[lines.first - above], count);
    };
    std::size_t above = 0;
    if (names(1))
        above = names(2) && isUnits(lines.fields[lines.first - 1]) ? 2 : 1;
    format.header = above > 0;
    format.linesBelow = above > 0 ? above - 1 : 0;
    const std::size_t top = lines.first - above;
    format.skippedLines = top > 0 ? head[top - 1].number : 0;
}

/// The lines from the header on, as `format` says.
ForeignTable tableBy(const std::vector<HeadLine>& head, const CsvFormat& format)
{
    ForeignTable table{format, {}, {}, {}};
    QStringList below;
    std::size_t passed = 0;
    bool started = !format.header;
    for (const HeadLine& line : head) {
        if (line.number <= format.skippedLines)
            continue;
        const QStringList fields = fieldsOf(line.text, format.delimiter);
        if (!started) {
            table.columns = fields;
            started = true;
        } else if (format.header && passed < format.linesBelow) {
            if (passed++ == 0)
                below = fields;
        } else if (table.rows.size() < shownRows) {
            table.rows.push_back(fields);
        }
    }
    if (!format.header && !table.rows.empty())
        for (qsizetype i = 0; i < table.rows.front().size(); ++i)
            table.columns << QString::number(i + 1);
    for (qsizetype i = 0; i < table.columns.size(); ++i) {
        const QString stated = unitOfName(table.columns[i]);
        const QString under = plainUnit(below.value(i));
        table.units << (stated.isEmpty() && isUnit(under) ? under : stated);
    }
    return table;
}

bool beginsWithOne(const QString& name, std::initializer_list<const char16_t*> beginnings)
{
    return std::any_of(beginnings.begin(), beginnings.end(), [&name](const char16_t* beginning) {
        return name.startsWith(QStringView(beginning), Qt::CaseInsensitive);
    });
}

bool isOne(const QString& name, std::initializer_list<const char16_t*> names)
{
    const QString first =
        name.section(QChar(u' '), 0, 0).section(QChar(u'['), 0, 0).section(QChar(u'('), 0, 0);
    const QString bare = first.section(QChar(u'/'), 0, 0).section(QChar(u'_'), 0, 0);
    return std::any_of(names.begin(), names.end(), [&bare](const char16_t* one) {
        return bare.compare(QStringView(one), Qt::CaseInsensitive) == 0;
    });
}

enum class Quantity { Time, Force, Position };

bool isNamedAs(const QString& name, Quantity quantity)
{
    switch (quantity) {
    case Quantity::Time:
        return beginsWithOne(name, {u"time", u"zeit"}) || isOne(name, {u"t"});
    case Quantity::Force:
        return beginsWithOne(name, {u"force", u"kraft", u"load", u"last"}) || isOne(name, {u"f", u"u"});
    case Quantity::Position:
        return beginsWithOne(name,
                             {u"pos", u"weg", u"displacement", u"travel", u"stroke", u"hub", u"auslenk"}) ||
               isOne(name, {u"x", u"y", u"s"});
    }
    return false;
}

bool isUnitOf(const QString& unit, Quantity quantity)
{
    switch (quantity) {
    case Quantity::Time:
        return secondsPer(unit).has_value();
    case Quantity::Force:
        return newtonsPer(unit).has_value();
    case Quantity::Position:
        return metresPer(unit).has_value();
    }
    return false;
}

using Taken = std::vector<qsizetype>;

constexpr qsizetype noColumn = -1;

qsizetype columnFor(const ForeignTable& table, Quantity quantity, const Taken& taken)
{
    const auto find = [&](const auto& fits) {
        for (qsizetype i = 0; i < table.columns.size(); ++i)
            if (std::find(taken.begin(), taken.end(), i) == taken.end() && fits(i))
                return i;
        return noColumn;
    };
    // A name may lie less than a unit does: several columns can be in newtons.
    const qsizetype named = find([&](qsizetype i) { return isNamedAs(table.columns[i], quantity); });
    return named != noColumn ? named : find([&](qsizetype i) { return isUnitOf(table.units[i], quantity); });
}

std::optional<double> numberAt(const ForeignTable& table, const QStringList& row, qsizetype column)
{
    return numberIn(row.value(column), table.format.decimalMark);
}

bool increases(const ForeignTable& table, qsizetype column)
{
    std::optional<double> before;
    for (const QStringList& row : table.rows) {
        const std::optional<double> now = numberAt(table, row, column);
        if (!now || (before && !(*now > *before)))
            return false;
        before = now;
    }
    return table.rows.size() > 1;
}

/// A column of numbers that nothing else is.
qsizetype leftOver(const ForeignTable& table, const Taken& taken)
{
    for (qsizetype i = 0; i < table.columns.size(); ++i)
        if (std::find(taken.begin(), taken.end(), i) == taken.end() && !table.rows.empty() &&
            numberAt(table, table.rows.front(), i))
            return i;
    for (qsizetype i = 0; i < table.columns.size(); ++i)
        if (std::find(taken.begin(), taken.end(), i) == taken.end())
            return i;
    return 0;
}

bool isUtf16(const QByteArray& bytes)
{
    return bytes.startsWith("\xff\xfe") || bytes.startsWith("\xfe\xff");
}

} // namespace

std::optional<double> secondsPer(const QString& unit)
{
    constexpr std::array<std::pair<const char16_t*, double>, 6> table{
        {{u"s", 1.0}, {u"ms", 1e-3}, {u"us", 1e-6}, {u"\u00b5s", 1e-6}, {u"\u03bcs", 1e-6}, {u"ns", 1e-9}}};
    for (const auto& entry : table)
        if (unit == QStringView(entry.first))
            return entry.second;
    return std::nullopt;
}

QStringList timeUnits()
{
    return {u"s"_s, u"ms"_s, u"\u00b5s"_s, u"ns"_s};
}

QByteArray tableText(const QByteArray& bytes)
{
    if (isUtf16(bytes)) {
        QStringDecoder decoder(QStringDecoder::Utf16);
        const QString text = decoder(bytes);
        return text.toUtf8();
    }
    const std::string_view view{bytes.constData(), static_cast<std::size_t>(bytes.size())};
    if (isUtf8(view))
        return bytes;
    QByteArray text;
    text.reserve(bytes.size() + bytes.size() / 8);
    for (const char byte : bytes) {
        const auto code = static_cast<unsigned char>(byte);
        if (code < 0x80) {
            text += byte;
        } else {
            text += static_cast<char>(0xC0 | (code >> 6));
            text += static_cast<char>(0x80 | (code & 0x3F));
        }
    }
    return text;
}

Expected<ForeignTable> examineTable(const QByteArray& head, const QString& name,
                                    const std::optional<CsvFormat>& given)
{
    const std::vector<HeadLine> lines = headLines(head);
    ForeignTable table;
    if (given) {
        table = tableBy(lines, *given);
    } else if (const Lines best = mostNumbers(lines); best.rowsCount > 0) {
        CsvFormat format;
        format.delimiter = best.delimiter;
        format.decimalMark = best.decimalMark;
        findHeader(lines, best, format);
        table = tableBy(lines, format);
    }
    if (table.columns.size() < 2 || table.rows.empty())
        return failure(ErrorCode::BadInput,
                       {u"%1:1:1"_s.arg(name), Words::say("found no two columns of numbers"),
                        Words::say("expected a table with commas, semicolons or tabs")});
    return table;
}

CsvReadOptions proposedReading(const ForeignTable& table)
{
    CsvReadOptions options;
    options.format = table.format;
    Taken taken;
    const auto take = [&taken](qsizetype column) {
        if (column != noColumn)
            taken.push_back(column);
        return column;
    };
    const bool spare = table.columns.size() > 2;
    qsizetype time = spare ? columnFor(table, Quantity::Time, taken) : noColumn;
    if (time == noColumn && spare && increases(table, 0))
        time = 0;
    take(time);
    qsizetype force = take(columnFor(table, Quantity::Force, taken));
    qsizetype position = take(columnFor(table, Quantity::Position, taken));
    if (force == noColumn)
        force = take(leftOver(table, taken));
    if (position == noColumn)
        position = leftOver(table, taken);
    CsvColumns columns;
    columns.force = static_cast<std::size_t>(force);
    columns.position = static_cast<std::size_t>(position);
    if (time != noColumn) {
        columns.time = static_cast<std::size_t>(time);
        options.timeUnit_s = secondsPer(table.units[time]).value_or(1);
    }
    options.columns = columns;
    if (const QString unit = table.units[force]; newtonsPer(unit))
        options.forceUnit = unit;
    if (const QString unit = table.units[position]; metresPer(unit))
        options.positionUnit = unit;
    return options;
}

QString layoutKey(const ForeignTable& table)
{
    QByteArray told(1, table.format.delimiter);
    if (table.format.header)
        told += table.columns.join(u'\n').toUtf8();
    else
        told += QByteArray::number(table.columns.size());
    return QString::fromLatin1(QCryptographicHash::hash(told, QCryptographicHash::Sha256).toHex().left(32));
}

Expected<QByteArray> readTableHead(const QString& file)
{
    QFile in(file);
    RETURN_IF_ERROR(openRegular(in));
    QByteArray bytes = in.read(tableHeadBytes);
    const bool cut = !in.atEnd();
    const auto toLineEnd = [cut](QByteArray text) {
        if (const qsizetype end = text.lastIndexOf('\n'); cut && end > 0)
            text.truncate(end + 1);
        return text;
    };
    if (!isUtf16(bytes)) // else a letter could be cut, and be taken for Latin-1
        bytes = toLineEnd(std::move(bytes));
    return toLineEnd(tableText(bytes));
}

Expected<Recording> readForeignTable(const QString& file, const CsvReadOptions& options)
{
    ASSIGN_OR_RETURN(const QByteArray bytes, readBounded(file, largestRecordingFile));
    return parseRecordingCsv(tableText(bytes), file, options);
}

} // namespace gripscope
