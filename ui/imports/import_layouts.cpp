// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/imports/import_layouts.h"

#include "core/signal/recording/recording_limits.h"
#include "core/signal/recording/units.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

constexpr qsizetype mostLayouts = 32;
/// More lines or columns than anybody's table has around its rows.
constexpr int mostCounted = 10'000;

QJsonObject toDocument(const QString& key, const CsvReadOptions& options)
{
    const CsvFormat& format = options.format;
    QJsonObject document{{u"layout"_s, key},
                         {u"delimiter"_s, QString(QLatin1Char(format.delimiter))},
                         {u"decimal_mark"_s, QString(QLatin1Char(format.decimalMark))},
                         {u"skipped_lines"_s, qint64(format.skippedLines)},
                         {u"header"_s, format.header},
                         {u"lines_below"_s, qint64(format.linesBelow)},
                         {u"time_unit_s"_s, options.timeUnit_s},
                         {u"force_unit"_s, options.forceUnit},
                         {u"position_unit"_s, options.positionUnit}};
    if (options.columns) {
        document[u"force"_s] = qint64(options.columns->force);
        document[u"position"_s] = qint64(options.columns->position);
        if (options.columns->time)
            document[u"time"_s] = qint64(*options.columns->time);
    }
    if (options.sampleTime_s)
        document[u"sample_time_s"_s] = *options.sampleTime_s;
    if (options.hold)
        document[u"force_hold"_s] = toString(*options.hold);
    return document;
}

std::optional<std::size_t> countOf(const QJsonValue& value)
{
    const int count = value.toInt(-1);
    return count >= 0 && count <= mostCounted ? std::optional(static_cast<std::size_t>(count)) : std::nullopt;
}

std::optional<CsvFormat> formatOf(const QJsonObject& document)
{
    const QString delimiter = document[u"delimiter"_s].toString();
    const QString mark = document[u"decimal_mark"_s].toString();
    const auto skipped = countOf(document[u"skipped_lines"_s]);
    const auto below = countOf(document[u"lines_below"_s]);
    const bool known = delimiter == u"," || delimiter == u";" || delimiter == u"\t";
    if (!known || (mark != u"." && mark != u",") || !skipped || !below)
        return std::nullopt;
    return CsvFormat{delimiter[0].toLatin1(), mark[0].toLatin1(), *skipped,
                     document[u"header"_s].toBool(true), *below};
}

std::optional<CsvReadOptions> fromDocument(const QJsonObject& document)
{
    const auto format = formatOf(document);
    const auto force = countOf(document[u"force"_s]);
    const auto position = countOf(document[u"position"_s]);
    if (!format || !force || !position)
        return std::nullopt;
    CsvReadOptions options;
    options.format = *format;
    options.columns = CsvColumns{*force, *position, countOf(document[u"time"_s])};
    options.timeUnit_s = document[u"time_unit_s"_s].toDouble(1);
    if (!(options.timeUnit_s >= shortestTimeUnit_s && options.timeUnit_s <= longestTimeUnit_s))
        return std::nullopt;
    if (const QString unit = document[u"force_unit"_s].toString(); newtonsPer(unit))
        options.forceUnit = unit;
    if (const QString unit = document[u"position_unit"_s].toString(); metresPer(unit))
        options.positionUnit = unit;
    if (const double seconds = document[u"sample_time_s"_s].toDouble(); isSampleTime(seconds))
        options.sampleTime_s = seconds;
    options.hold = forceHoldFromString(document[u"force_hold"_s].toString());
    return options;
}

} // namespace

QByteArray withLayout(const QByteArray& kept, const ForeignTable& table, const CsvReadOptions& options)
{
    const QString key = layoutKey(table);
    QJsonObject document = toDocument(key, options);
    document[u"format_as_found"_s] = options.format == table.format;
    QJsonArray layouts{document};
    for (const QJsonValue& value : QJsonDocument::fromJson(kept).array())
        if (value.toObject()[u"layout"_s].toString() != key && layouts.size() < mostLayouts)
            layouts.append(value);
    return QJsonDocument(layouts).toJson(QJsonDocument::Compact);
}

std::optional<CsvReadOptions> layoutIn(const QByteArray& kept, const ForeignTable& table)
{
    const QString key = layoutKey(table);
    for (const QJsonValue& value : QJsonDocument::fromJson(kept).array()) {
        const QJsonObject document = value.toObject();
        if (document[u"layout"_s].toString() != key)
            continue;
        std::optional<CsvReadOptions> options = fromDocument(document);
        if (options && document[u"format_as_found"_s].toBool())
            options->format = table.format;
        return options;
    }
    return std::nullopt;
}

} // namespace gripscope
