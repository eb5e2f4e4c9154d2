// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/recognition/table_lines.h"

#include "core/words.h"

#include <QFile>

#include <optional>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

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

tl::unexpected<Error> TablePlace::error(const QString& found, const QString& expected) const
{
    return failure(ErrorCode::BadInput,
                   {text(), Words::tr("found %1").arg(found), Words::tr("expected %1").arg(expected)});
}

Expected<QByteArray> readTableFile(const QString& file)
{
    QFile in(file);
    if (!in.open(QIODevice::ReadOnly))
        return failure(ErrorCode::FileUnreadable, {file, in.errorString()});
    QByteArray text = in.readAll();
    if (in.error() != QFileDevice::NoError)
        return failure(ErrorCode::FileUnreadable, {file, in.errorString()});
    return text;
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
            return TablePlace{name, number, 1}.error(Words::tr("a quote that is not closed"),
                                                     Words::tr("a closing quote on the same line"));
        lines.push_back({number, std::move(*fields)});
    }
    if (lines.empty())
        return TablePlace{name}.error(Words::tr("an empty file"), Words::tr("a header and rows"));
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
                Words::tr("the columns %1").arg(header.fields.join(", "_L1)),
                Words::tr("a column called %1").arg(feature));
        if (const qsizetype again = header.fields.indexOf(feature, column + 1); again >= 0)
            return TablePlace{name, header.number, again + 1}.error(
                Words::tr("a second column called %1").arg(feature), Words::tr("each name once"));
        columns.push_back(column);
    }
    if (lines.size() == 1)
        return TablePlace{name, header.number + 1, 1}.error(Words::tr("no rows"),
                                                            Words::tr("at least one row below the header"));
    return columns;
}

} // namespace gripscope
