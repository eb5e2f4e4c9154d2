// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <QByteArray>
#include <QString>

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

namespace gripscope {

/// One cell of a CSV file after RFC 4180: in quotes where it has to be. A text that a spreadsheet would take
/// for a formula (it begins with = + - @, a tab or a line end, and is no number) gets an apostrophe in front,
/// by which spreadsheets know a text.
[[nodiscard]] QString csvCell(const QString& text);

/// The lines of a text in memory, without their ends (LF or CR LF) and without a byte order mark, and the
/// words for what is wrong with them. Holds a view: the text must outlive it.
class CsvLineReader {
public:
    CsvLineReader(const QByteArray& text, QString name);

    /// The next line that is not blank, or nothing at the end.
    [[nodiscard]] std::optional<std::string_view> next();
    /// Counted from 1, as editors do; of the line next() gave last.
    [[nodiscard]] std::size_t lineNumber() const { return m_lineNumber; }

    /// BadInput at the current line; `column` counts fields from 1.
    [[nodiscard]] tl::unexpected<Error> bad(std::size_t column, const Finding& found,
                                            const Finding& expected) const;

private:
    std::string_view m_text;
    QString m_name;
    std::size_t m_position = 0;
    std::size_t m_lineNumber = 0;
};

/// Splits at `delimiter`: commas, semicolons or tabs. A field may stand in double quotes, a quote within it
/// doubled. False: a quote is not closed, or something follows it. `fields` is overwritten; `unquoted` owns
/// the texts that had to be changed.
[[nodiscard]] bool splitCsvLine(std::string_view line, std::vector<std::string_view>& fields,
                                std::vector<QByteArray>& unquoted, char delimiter = ',');

/// The number a field holds: finite, C locale, spaces around it allowed, nothing else.
[[nodiscard]] std::optional<double> parseNumber(std::string_view field);
/// The same with a decimal mark of its own, a point or a comma; a field with the other one holds none.
[[nodiscard]] std::optional<double> parseNumber(std::string_view field, char decimalMark);
/// The same for a whole number from 0 up to `largest`.
[[nodiscard]] std::optional<std::uint64_t> parseCount(std::string_view field, std::uint64_t largest);

/// The shortest text that parseNumber() reads back to the same bits; empty where there is no finite number.
[[nodiscard]] QString exactText(std::optional<double> number);

[[nodiscard]] std::string_view trimmed(std::string_view text);
[[nodiscard]] bool isUtf8(std::string_view text);
/// A key or a value of a file's head as it stands on one line: control characters, line ends of any kind and
/// byte order marks are spaces, and none stand around it. Written by the same rule, it reads back as it is.
[[nodiscard]] QString factText(QString text);
[[nodiscard]] QString factText(std::string_view utf8);
/// For a message: the start of a text, bytes that are not UTF-8 replaced.
[[nodiscard]] QString quoted(std::string_view text);

} // namespace gripscope
