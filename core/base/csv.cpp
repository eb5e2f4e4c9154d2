// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/csv.h"

#include <QLocale>
#include <QStringDecoder>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string>

namespace gripscope {

namespace {

bool isFormula(const QString& text)
{
    if (text.isEmpty() || !QStringLiteral("=+-@\t\r\n").contains(text.front()))
        return false;
    bool isNumber = false;
    static_cast<void>(QLocale::c().toDouble(text, &isNumber));
    return !isNumber;
}

constexpr std::string_view byteOrderMark = "\xEF\xBB\xBF";

std::string_view view(const QByteArray& bytes)
{
    return {bytes.constData(), static_cast<std::size_t>(bytes.size())};
}

/// Reads the quoted field that starts at `position` and steps behind its closing quote.
std::optional<QByteArray> readQuoted(std::string_view line, std::size_t& position)
{
    QByteArray text;
    for (++position; position < line.size(); ++position) {
        if (line[position] != '"') {
            text += line[position];
            continue;
        }
        if (position + 1 < line.size() && line[position + 1] == '"') {
            text += line[++position];
            continue;
        }
        ++position;
        return text;
    }
    return std::nullopt;
}

} // namespace

QString csvCell(const QString& text)
{
    QString cell = isFormula(text) ? u'\'' + text : text;
    const bool plain =
        !cell.contains(u',') && !cell.contains(u'"') && !cell.contains(u'\n') && !cell.contains(u'\r');
    return plain ? cell : u'"' + cell.replace(u'"', QStringLiteral("\"\"")) + u'"';
}

CsvLineReader::CsvLineReader(const QByteArray& text, QString name)
    : m_text(view(text)), m_name(std::move(name))
{
    if (m_text.substr(0, byteOrderMark.size()) == byteOrderMark)
        m_position = byteOrderMark.size();
}

std::optional<std::string_view> CsvLineReader::next()
{
    while (m_position < m_text.size()) {
        const std::size_t end = std::min(m_text.find('\n', m_position), m_text.size());
        std::string_view line = m_text.substr(m_position, end - m_position);
        m_position = end + 1;
        ++m_lineNumber;
        if (!line.empty() && line.back() == '\r')
            line.remove_suffix(1);
        if (!trimmed(line).empty())
            return line;
    }
    return std::nullopt;
}

tl::unexpected<Error> CsvLineReader::bad(std::size_t column, const Finding& found,
                                         const Finding& expected) const
{
    const QString place =
        QStringLiteral("%1:%2:%3").arg(m_name).arg(std::max<std::size_t>(m_lineNumber, 1)).arg(column);
    return failure(ErrorCode::BadInput, {place, found, expected});
}

bool splitCsvLine(std::string_view line, std::vector<std::string_view>& fields,
                  std::vector<QByteArray>& unquoted, char delimiter)
{
    const std::string_view blanks = delimiter == '\t' ? std::string_view(" ") : std::string_view(" \t");
    fields.clear();
    if (line.find('"') == std::string_view::npos) {
        for (std::size_t begin = 0;;) {
            const std::size_t end = line.find(delimiter, begin);
            fields.push_back(trimmed(line.substr(begin, end - begin)));
            if (end == std::string_view::npos)
                return true;
            begin = end + 1;
        }
    }
    unquoted.clear();
    for (std::size_t position = 0;;) {
        const std::size_t end = std::min(line.find(delimiter, position), line.size());
        const std::size_t first = std::min(line.find_first_not_of(blanks, position), line.size());
        if (first < end && line[first] == '"') {
            position = first;
            std::optional<QByteArray> text = readQuoted(line, position);
            if (!text)
                return false;
            unquoted.push_back(*text);
            position = std::min(line.find_first_not_of(blanks, position), line.size());
            if (position < line.size() && line[position] != delimiter)
                return false;
        } else {
            const std::string_view field = trimmed(line.substr(position, end - position));
            unquoted.emplace_back(field.data(), static_cast<qsizetype>(field.size()));
            position = end;
        }
        if (position >= line.size())
            break;
        ++position;
    }
    for (const QByteArray& text : unquoted)
        fields.push_back(view(text));
    return true;
}

std::optional<double> parseNumber(std::string_view field)
{
    field = trimmed(field);
    if (field.size() > 1 && field[0] == '+' && field[1] != '-')
        field.remove_prefix(1);
    double value = 0;
    const char* const end = field.data() + field.size();
    const auto result = std::from_chars(field.data(), end, value);
    if (result.ec != std::errc() || result.ptr != end || !std::isfinite(value))
        return std::nullopt;
    return value;
}

std::optional<double> parseNumber(std::string_view field, char decimalMark)
{
    if (decimalMark != ',')
        return parseNumber(field);
    field = trimmed(field);
    const std::size_t comma = field.find(',');
    if (comma == std::string_view::npos)
        return field.find('.') == std::string_view::npos ? parseNumber(field) : std::nullopt;
    constexpr std::size_t longest = 400; // the longest double written out has fewer digits
    if (field.size() > longest || field.find('.') != std::string_view::npos)
        return std::nullopt;
    std::string text(field);
    text[comma] = '.';
    return parseNumber(text);
}

std::optional<std::uint64_t> parseCount(std::string_view field, std::uint64_t largest)
{
    field = trimmed(field);
    std::uint64_t value = 0;
    const char* const end = field.data() + field.size();
    const auto result = std::from_chars(field.data(), end, value);
    if (result.ec != std::errc() || result.ptr != end || value > largest)
        return std::nullopt;
    return value;
}

QString exactText(std::optional<double> number)
{
    return number && std::isfinite(*number) ? QString::number(*number, 'g', QLocale::FloatingPointShortest)
                                            : QString();
}

std::string_view trimmed(std::string_view text)
{
    const auto isSpace = [](char c) { return c == ' ' || c == '\t'; };
    while (!text.empty() && isSpace(text.front()))
        text.remove_prefix(1);
    while (!text.empty() && isSpace(text.back()))
        text.remove_suffix(1);
    return text;
}

bool isUtf8(std::string_view text)
{
    if (std::none_of(text.begin(), text.end(),
                     [](char c) { return (static_cast<unsigned char>(c) & 0x80U) != 0; }))
        return true;
    QStringDecoder decoder(QStringDecoder::Utf8);
    const QString decoded = decoder(QByteArrayView(text.data(), static_cast<qsizetype>(text.size())));
    // A sequence cut off at the end is no error of the decoder's: it would wait for more.
    const QString rest = decoder(QByteArrayView(" ", 1));
    return !decoder.hasError() && !decoded.isEmpty() && rest == QLatin1String(" ");
}

QString factText(QString text)
{
    const auto isBreak = [](QChar c) {
        return c == QChar(QChar::ByteOrderMark) || c.category() == QChar::Other_Control ||
               c.category() == QChar::Separator_Line || c.category() == QChar::Separator_Paragraph;
    };
    for (QChar& c : text) {
        if (isBreak(c))
            c = QLatin1Char(' ');
    }
    return text.trimmed();
}

QString factText(std::string_view utf8)
{
    return factText(QString::fromUtf8(utf8.data(), static_cast<qsizetype>(utf8.size())));
}

QString quoted(std::string_view text)
{
    constexpr std::size_t longest = 40;
    const bool cut = text.size() > longest;
    const std::string_view shown = text.substr(0, longest);
    QString words = QString::fromUtf8(shown.data(), static_cast<qsizetype>(shown.size()));
    for (QChar& c : words) {
        if (!c.isPrint() && !c.isSurrogate())
            c = QChar(QChar::ReplacementCharacter);
    }
    return QStringLiteral("\"%1%2\"").arg(words, cut ? QStringLiteral("...") : QString());
}

} // namespace gripscope
