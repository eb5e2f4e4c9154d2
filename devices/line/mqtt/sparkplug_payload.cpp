// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/line/mqtt/sparkplug_payload.h"

#include <QJsonDocument>
#include <QJsonObject>

#include <algorithm>
#include <sparkplug_b.pb.h>
#include <string>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

constexpr qsizetype longestState = 4096;

std::uint64_t millisecondsOf(const QDateTime& time)
{
    return static_cast<std::uint64_t>(std::max<qint64>(0, time.toMSecsSinceEpoch()));
}

void putNumber(sparkplug::Metric& metric, SparkplugType type, quint64 number)
{
    if (type == SparkplugType::UInt16 || type == SparkplugType::UInt32)
        metric.set_int_value(static_cast<std::uint32_t>(number));
    else
        metric.set_long_value(number);
}

void putValue(sparkplug::Metric& metric, const SparkplugMetric& from)
{
    if (const auto* number = std::get_if<quint64>(&from.value))
        putNumber(metric, from.type, *number);
    else if (const auto* real = std::get_if<double>(&from.value))
        metric.set_double_value(*real);
    else if (const auto* truth = std::get_if<bool>(&from.value))
        metric.set_boolean_value(*truth);
    else if (const auto* text = std::get_if<QString>(&from.value))
        metric.set_string_value(text->toStdString());
    else
        metric.set_is_null(true);
}

} // namespace

QByteArray encoded(const SparkplugPayload& payload)
{
    sparkplug::Payload message;
    if (payload.sent)
        message.set_timestamp(millisecondsOf(*payload.sent));
    for (const SparkplugMetric& from : payload.metrics) {
        sparkplug::Metric& metric = *message.add_metrics();
        if (!from.name.isEmpty())
            metric.set_name(from.name.toStdString());
        if (from.alias)
            metric.set_alias(*from.alias);
        if (payload.measured.isValid())
            metric.set_timestamp(millisecondsOf(payload.measured));
        if (from.typed)
            metric.set_datatype(static_cast<std::uint32_t>(from.type));
        if (from.historical)
            metric.set_is_historical(true);
        putValue(metric, from);
    }
    if (payload.seq)
        message.set_seq(*payload.seq);
    return QByteArray::fromStdString(message.SerializeAsString());
}

NodeCommand decodedCommand(const QByteArray& bytes)
{
    sparkplug::Payload message;
    if (bytes.size() > longestCommand ||
        !message.ParseFromArray(bytes.constData(), static_cast<int>(bytes.size())))
        return NodeCommand::Unreadable;
    for (const sparkplug::Metric& metric : message.metrics())
        if (metric.name() == sparkplug_name::rebirth && metric.boolean_value())
            return NodeCommand::Rebirth;
    return NodeCommand::None;
}

std::optional<HostState> decodedHostState(const QByteArray& bytes)
{
    if (bytes.size() > longestState)
        return {};
    const QJsonObject object = QJsonDocument::fromJson(bytes).object();
    const QJsonValue online = object["online"_L1], timestamp = object["timestamp"_L1];
    if (!online.isBool() || !timestamp.isDouble() || timestamp.toInteger(-1) < 0)
        return {};
    return HostState{online.toBool(), timestamp.toInteger()};
}

QString hostStateTopic(const QString& host)
{
    return u"%1/STATE/%2"_s.arg(QString::fromLatin1(sparkplug_name::space), host);
}

void PrimaryHost::hear(const HostState& state)
{
    if (!m_last || state.timestamp >= m_last->timestamp)
        m_last = state;
}

} // namespace gripscope
