// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/recognition/feature_table.h"

#include <QFile>

#include <cmath>
#include <optional>
#include <vector>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

struct Line {
    int number = 0;
    QStringList fields;
};

/// Where an error is: FILE:LINE:COLUMN, the column counted in fields from 1.
struct Place {
    QString file;
    int line = 1;
    qsizetype column = 1;
    [[nodiscard]] tl::unexpected<Error> error(const QString& found, const QString& expected) const
    {
        return failure(ErrorCode::BadInput,
                       {u"%1:%2:%3"_s.arg(file, QString::number(line), QString::number(column)),
                        u"found "_s + found, u"expected "_s + expected});
    }
};

/// Fields between commas; a field may stand in double quotes, a quote inside it doubled (RFC 4180). Nothing
/// when a quote stays open.
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

/// The lines that hold fields; empty ones and comments (#) are passed over.
Expected<std::vector<Line>> splitLines(const QByteArray& text, const QString& name)
{
    std::vector<Line> lines;
    int number = 0;
    const QByteArray body = text.startsWith("\xef\xbb\xbf") ? text.mid(3) : text; // byte order mark
    for (const QByteArray& raw : body.split('\n')) {
        ++number;
        const QByteArray trimmed = raw.trimmed();
        if (trimmed.isEmpty() || trimmed.startsWith('#'))
            continue;
        auto fields = splitFields(QString::fromUtf8(trimmed));
        if (!fields)
            return Place{name, number, 1}.error(u"a quote that is not closed"_s,
                                                u"a closing quote on the same line"_s);
        lines.push_back({number, std::move(*fields)});
    }
    return lines;
}

/// Columns of the header in the order of `wanted`.
Expected<std::vector<qsizetype>> findColumns(const Line& header, const QStringList& wanted,
                                             const QString& name)
{
    std::vector<qsizetype> columns;
    for (const QString& feature : wanted) {
        const qsizetype column = header.fields.indexOf(feature);
        if (column < 0)
            return Place{name, header.number, 1}.error(u"the columns %1"_s.arg(header.fields.join(", "_L1)),
                                                       u"a column called %1"_s.arg(feature));
        if (const qsizetype again = header.fields.indexOf(feature, column + 1); again >= 0)
            return Place{name, header.number, again + 1}.error(u"a second column called %1"_s.arg(feature),
                                                               u"each name once"_s);
        columns.push_back(column);
    }
    return columns;
}

} // namespace

Expected<FeatureTable> parseFeatureTable(const QByteArray& text, const QString& name,
                                         const QStringList& features, const QString& truthColumn)
{
    if (features.isEmpty())
        return failure(ErrorCode::Usage, {u"No feature is named."_s});
    const auto lines = splitLines(text, name);
    if (!lines)
        return tl::unexpected(lines.error());
    if (lines->empty())
        return Place{name}.error(u"an empty file"_s, u"a header and rows"_s);
    const Line& header = lines->front();
    const auto columns =
        findColumns(header, truthColumn.isEmpty() ? features : features + QStringList{truthColumn}, name);
    if (!columns)
        return tl::unexpected(columns.error());
    if (lines->size() == 1)
        return Place{name, header.number + 1, 1}.error(u"no rows"_s, u"at least one row below the header"_s);

    FeatureTable table;
    table.features = features;
    table.values.resize(Eigen::Index(lines->size()) - 1, features.size());
    for (std::size_t i = 1; i < lines->size(); ++i) {
        const Line& line = (*lines)[i];
        if (line.fields.size() != header.fields.size())
            return Place{name, line.number, std::min(line.fields.size(), header.fields.size()) + 1}.error(
                u"%1 fields"_s.arg(line.fields.size()), u"%1, as in the header"_s.arg(header.fields.size()));
        for (qsizetype j = 0; j < features.size(); ++j) {
            const qsizetype column = (*columns)[std::size_t(j)];
            bool ok = false;
            const double value = line.fields[column].toDouble(&ok);
            if (!ok || !std::isfinite(value))
                return Place{name, line.number, column + 1}.error(u"\"%1\""_s.arg(line.fields[column]),
                                                                  u"a finite number"_s);
            table.values(Eigen::Index(i) - 1, j) = value;
        }
        if (!truthColumn.isEmpty())
            table.truth.append(line.fields[columns->back()]);
    }
    return table;
}

Expected<FeatureTable> readFeatureTable(const QString& file, const QStringList& features,
                                        const QString& truthColumn)
{
    QFile in(file);
    if (!in.open(QIODevice::ReadOnly))
        return failure(ErrorCode::FileUnreadable, {file, in.errorString()});
    const QByteArray text = in.readAll();
    if (in.error() != QFileDevice::NoError)
        return failure(ErrorCode::FileUnreadable, {file, in.errorString()});
    return parseFeatureTable(text, file, features, truthColumn);
}

} // namespace gripscope
