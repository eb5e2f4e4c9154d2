// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/history_document.h"

#include "core/identification/json_number.h"
#include "core/json_text.h"
#include "core/signal/units.h"

#include <QJsonDocument>
#include <QLocale>
#include <QStringList>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

constexpr std::size_t rowsAtOnce = 500;

QString quoted(QString text)
{
    const bool plain =
        !text.contains(u',') && !text.contains(u'"') && !text.contains(u'\n') && !text.contains(u'\r');
    return plain ? text : u'"' + text.replace(u'"', u"\"\""_s) + u'"';
}

QString number(const std::optional<double>& value)
{
    return value ? QString::number(*value, 'g', QLocale::FloatingPointShortest) : QString();
}

QString utc(const QDateTime& time)
{
    return time.toUTC().toString(Qt::ISODateWithMs);
}

QString outcomeText(const HistoryEntry& entry)
{
    const std::optional<InspectionOutcome> outcome = entry.outcome();
    return outcome ? toString(*outcome) : QString();
}

QStringList cells(const HistoryEntry& entry)
{
    const ParameterUnits units = parameterUnits(entry.forceUnit, entry.positionUnit);
    const auto& p = entry.parameters;
    const auto part = [&p](double MassDampingStiffness::*member) {
        return p ? std::optional((*p).*member) : std::nullopt;
    };
    const auto error = [&entry](int i) {
        return entry.standardErrors ? std::optional((*entry.standardErrors)(i)) : std::nullopt;
    };
    return {entry.number > 0 ? QString::number(entry.number) : QString(),
            utc(entry.time),
            toString(entry.kind),
            entry.expectedType,
            outcomeText(entry),
            entry.verdict ? toString(*entry.verdict) : QString(),
            entry.type,
            entry.nearest,
            number(entry.posterior),
            number(part(&MassDampingStiffness::m)),
            number(error(0)),
            p ? units.m : QString(),
            number(part(&MassDampingStiffness::b)),
            number(error(1)),
            p ? units.b : QString(),
            number(part(&MassDampingStiffness::k)),
            number(error(2)),
            p ? units.k : QString(),
            number(entry.simulationFitPercent),
            number(entry.seconds),
            entry.operatorName,
            entry.device,
            entry.serial,
            entry.firmware,
            entry.source,
            entry.part,
            entry.accepted ? u"yes"_s : u"no"_s,
            entry.estimator,
            entry.program,
            entry.graspId,
            entry.reason,
            entry.batch};
}

QJsonValue byName(const std::optional<Eigen::Vector3d>& values)
{
    if (!values)
        return {};
    return QJsonObject{{u"m"_s, jsonNumber((*values)(0))},
                       {u"b"_s, jsonNumber((*values)(1))},
                       {u"k"_s, jsonNumber((*values)(2))}};
}

QByteArray compact(const QJsonObject& object)
{
    return QJsonDocument(object).toJson(QJsonDocument::Compact);
}

} // namespace

QByteArray historyCsvHeader()
{
    return "number,time_utc,kind,expected,outcome,verdict,type,nearest,posterior,m,m_standard_error,m_unit,b,"
           "b_standard_error,b_unit,k,k_standard_error,k_unit,simulation_fit_percent,squeeze_s,operator,"
           "device,serial,firmware,source,part,accepted,estimator,software,key,reason,batch\n";
}

QByteArray toCsv(const std::vector<HistoryEntry>& entries)
{
    QString text;
    for (const HistoryEntry& entry : entries) {
        QStringList line;
        for (const QString& cell : cells(entry))
            line << quoted(cell);
        text += line.join(u',') + u'\n';
    }
    return text.toUtf8();
}

QJsonObject toJson(const HistoryEntry& entry)
{
    const ParameterUnits units = parameterUnits(entry.forceUnit, entry.positionUnit);
    const auto& p = entry.parameters;
    return {{u"key"_s, entry.graspId},
            {u"kind"_s, toString(entry.kind)},
            {u"number"_s, entry.number > 0 ? QJsonValue(entry.number) : QJsonValue()},
            {u"time_utc"_s, utc(entry.time)},
            {u"expected"_s, jsonText(entry.expectedType)},
            {u"outcome"_s, jsonText(outcomeText(entry))},
            {u"verdict"_s, entry.verdict ? QJsonValue(toString(*entry.verdict)) : QJsonValue()},
            {u"type"_s, jsonText(entry.type)},
            {u"nearest"_s, jsonText(entry.nearest)},
            {u"posterior"_s, jsonNumber(entry.posterior)},
            {u"distance"_s, jsonNumber(entry.distance)},
            {u"gate"_s, jsonNumber(entry.gate)},
            {u"false_reject_rate"_s, jsonNumber(entry.falseReject)},
            {u"wrong_type_rate"_s, jsonNumber(entry.wrongType)},
            {u"parameters"_s, byName(p ? std::optional(p->vector()) : std::nullopt)},
            {u"standard_errors"_s, byName(entry.standardErrors)},
            {u"units"_s, QJsonObject{{u"m"_s, units.m}, {u"b"_s, units.b}, {u"k"_s, units.k}}},
            {u"simulation_fit_percent"_s, jsonNumber(entry.simulationFitPercent)},
            {u"squeeze_s"_s, jsonNumber(entry.seconds)},
            {u"operator"_s, jsonText(entry.operatorName)},
            {u"device"_s, jsonText(entry.device)},
            {u"serial"_s, jsonText(entry.serial)},
            {u"firmware"_s, jsonText(entry.firmware)},
            {u"source"_s, jsonText(entry.source)},
            {u"part"_s, jsonText(entry.part)},
            {u"batch"_s, jsonText(entry.batch)},
            {u"accepted"_s, entry.accepted},
            {u"estimator"_s, jsonText(entry.estimator)},
            {u"software"_s, jsonText(entry.program)},
            {u"reason"_s, jsonText(entry.reason)}};
}

QJsonObject toJson(const HistoryQuery& query)
{
    QJsonObject object;
    const auto add = [&object](const QString& name, const QString& text) {
        if (!text.isEmpty())
            object.insert(name, text);
    };
    add(u"text"_s, query.text);
    add(u"kind"_s, query.kind ? toString(*query.kind) : QString());
    add(u"outcome"_s, query.outcome ? toString(*query.outcome) : QString());
    add(u"type"_s, query.type);
    add(u"expected"_s, query.expected);
    add(u"operator"_s, query.operatorName);
    add(u"device"_s, query.device);
    add(u"from_utc"_s, query.from.isValid() ? utc(query.from) : QString());
    add(u"to_utc"_s, query.to.isValid() ? utc(query.to) : QString());
    return object;
}

HistoryDocument::HistoryDocument(HistoryQuery query, HistoryFormat format)
    : m_query(std::move(query)), m_format(format)
{
}

QByteArray HistoryDocument::head() const
{
    if (m_format == HistoryFormat::Csv)
        return historyCsvHeader();
    QByteArray text = compact({{u"format"_s, u"gripscope-history"_s},
                               {u"version"_s, 1},
                               {u"software"_s, QStringLiteral(GRIPSCOPE_VERSION)},
                               {u"exported_utc"_s, utc(QDateTime::currentDateTimeUtc())},
                               {u"filter"_s, toJson(m_query)},
                               {u"count"_s, qint64(total())}});
    text.chop(1); // the closing brace comes at the end
    return text + ",\"squeezes\":[\n";
}

QByteArray HistoryDocument::rows(const std::vector<HistoryEntry>& entries)
{
    if (m_format == HistoryFormat::Csv)
        return toCsv(entries);
    QByteArray text;
    for (const HistoryEntry& entry : entries) {
        text += m_first ? QByteArray() : QByteArray(",\n");
        text += compact(toJson(entry));
        m_first = false;
    }
    return text;
}

Expected<QByteArray> HistoryDocument::next(Library& library)
{
    if (m_ended)
        return QByteArray();
    QByteArray text;
    if (!m_keys) {
        Expected<HistoryKeys> keys = library.historyKeys(m_query);
        if (!keys)
            return tl::unexpected<Error>(keys.error());
        m_keys = std::move(*keys);
        text = head();
    }
    const std::vector<QString> part = m_keys->part(m_written, rowsAtOnce);
    const Expected<std::vector<HistoryEntry>> entries = library.historyEntries(part);
    if (!entries)
        return tl::unexpected<Error>(entries.error());
    text += rows(*entries);
    m_written += part.size();
    m_ended = m_written >= m_keys->size();
    if (m_ended && m_format == HistoryFormat::Json)
        text += "\n]}\n";
    return text;
}

} // namespace gripscope
