// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/table_lines.h"

#include "core/base/bounded_file.h"
#include "core/base/words.h"

#include <optional>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

/// A hundred thousand squeezes have 10 MB; each field takes thirty times its bytes while it is read.
constexpr qint64 largestTable = 16 * megabyte;

/// Nothing when a quote stays open.
std::optional<QStringList> splitFields(const QString& line)
{
    QStringList fields;
    QString field;
    bool quoted = false;
    for (qsizetype i = 0; i < line.size(); ++i) {
        const QChar c = line[i];
        if (c == u'"' && quoted && i + 1 < line.size() && line[i + 1] == u'"') {
            field += c;
            ++i;
        } else if (c == u'"') {
            quoted = !quoted;
        } else if (c == u',' && !quoted) {
            fields.append(field.trimmed());
            field.clear();
        } else {
            field += c;
        }
    }
    fields.append(field.trimmed());
    return quoted ? std::nullopt : std::optional(fields);
}

} // namespace

QString TablePlace::text() const
{
    return u"%1:%2:%3"_s.arg(file, QString::number(line), QString::number(column));
}

tl::unexpected<Error> TablePlace::error(const Finding& found, const Finding& expected) const
{
    return failure(ErrorCode::BadInput,
                   {text(), Words::say("found %1").arg(found), Words::say("expected %1").arg(expected)});
}

Expected<QByteArray> readTableFile(const QString& file)
{
    return readBounded(file, largestTable);
}

Expected<std::vector<TableLine>> splitTable(const QByteArray& text, const QString& name)
{
    std::vector<TableLine> lines;
    int number = 0;
    const QByteArray body = text.startsWith("\xef\xbb\xbf") ? text.mid(3) : text; // byte order mark
    for (const QByteArray& raw : body.split('\n')) {
        ++number;
        const QByteArray trimmed = raw.trimmed();
        if (trimmed.isEmpty() || trimmed.startsWith('#'))
            continue;
        auto fields = splitFields(QString::fromUtf8(trimmed));
        if (!fields)
            return TablePlace{name, number, 1}.error(Words::say("a quote that is not closed"),
                                                     Words::say("a closing quote on the same line"));
        lines.push_back({number, std::move(*fields)});
    }
    if (lines.empty())
        return TablePlace{name}.error(Words::say("an empty file"), Words::say("a header and rows"));
    return lines;
}

Expected<std::vector<qsizetype>> findTableColumns(const std::vector<TableLine>& lines,
                                                  const QStringList& wanted, const QString& name)
{
    const TableLine& header = lines.front();
    std::vector<qsizetype> columns;
    columns.reserve(std::size_t(wanted.size()));
    for (const QString& feature : wanted) {
        const qsizetype column = header.fields.indexOf(feature);
        if (column < 0)
            return TablePlace{name, header.number, 1}.error(
                Words::say("the columns %1").arg(header.fields.join(", "_L1)),
                Words::say("a column called %1").arg(feature));
        if (const qsizetype again = header.fields.indexOf(feature, column + 1); again >= 0)
            return TablePlace{name, header.number, again + 1}.error(
                Words::say("a second column called %1").arg(feature), Words::say("each name once"));
        columns.push_back(column);
    }
    if (lines.size() == 1)
        return TablePlace{name, header.number + 1, 1}.error(Words::say("no rows"),
                                                            Words::say("at least one row below the header"));
    return columns;
}

} // namespace gripscope
