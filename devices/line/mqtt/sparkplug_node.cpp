// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/line/mqtt/sparkplug_node.h"

#include "devices/line/mqtt/result_metrics.h"
#include "devices/line/mqtt/sparkplug_names.h"

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

constexpr int deathQos = 1; // of the will; all else is sent with 0, as the specification has it
/// Below it are the node's own, of which none has an alias.
constexpr std::uint64_t firstDeviceAlias = 1;

SparkplugMetric birthDeathMetric(std::uint8_t number)
{
    SparkplugMetric metric;
    metric.name = QString::fromLatin1(sparkplug_name::birthDeath);
    metric.type = SparkplugType::UInt64;
    metric.value = quint64(number);
    return metric;
}

SparkplugMetric rebirthMetric()
{
    SparkplugMetric metric;
    metric.name = QString::fromLatin1(sparkplug_name::rebirth);
    metric.type = SparkplugType::Boolean;
    metric.value = false;
    return metric;
}

} // namespace

SparkplugNode::SparkplugNode(QString group, QString node, std::uint8_t birthDeath)
    : m_group(std::move(group)), m_node(std::move(node)), m_birthDeath(birthDeath)
{
}

QString SparkplugNode::deviceName(const QString& serial)
{
    QString name = serial.trimmed();
    for (QChar& letter : name)
        if (letter == u'/' || letter == u'+' || letter == u'#' || letter < u' ')
            letter = u'_';
    return name.isEmpty() ? u"gripper"_s : name;
}

QString SparkplugNode::topic(const char* kind, const QString& device) const
{
    const QString node = u"%1/%2/%3/%4"_s.arg(QString::fromLatin1(sparkplug_name::space), m_group,
                                              QString::fromLatin1(kind), m_node);
    return device.isEmpty() ? node : node + u'/' + device;
}

QString SparkplugNode::commandTopic() const
{
    return topic("NCMD");
}

MqttMessage SparkplugNode::death() const
{
    SparkplugPayload payload;
    payload.metrics = {birthDeathMetric(m_birthDeath)};
    return {topic("NDEATH"), encoded(payload), deathQos, false};
}

std::vector<MqttMessage> SparkplugNode::births(const QDateTime& now)
{
    m_seq = 0;
    m_born = true;
    SparkplugPayload payload;
    payload.sent = payload.measured = now;
    payload.seq = nextSeq();
    payload.metrics = {birthDeathMetric(m_birthDeath), rebirthMetric()};
    std::vector<MqttMessage> messages{{topic("NBIRTH"), encoded(payload)}};
    if (!m_present.isEmpty())
        device(m_present).alive = true;
    for (const auto& known : m_devices)
        if (known.second.alive)
            messages.push_back(deviceBirth(known.first, now));
    return messages;
}

SparkplugNode::Device& SparkplugNode::device(const QString& name)
{
    const auto known = m_devices.find(name);
    if (known != m_devices.end())
        return known->second;
    Device made;
    made.firstAlias = firstDeviceAlias + m_devices.size() * aliasesOfDevice;
    return m_devices.emplace(name, std::move(made)).first->second;
}

MqttMessage SparkplugNode::deviceBirth(const QString& name, const QDateTime& now)
{
    Device& born = device(name);
    born.alive = true;
    SparkplugPayload payload;
    payload.sent = payload.measured = now;
    payload.seq = nextSeq();
    payload.metrics = resultMetrics(born.last ? &*born.last : nullptr, born.firstAlias, MetricsFor::Birth);
    return {topic("DBIRTH", name), encoded(payload)};
}

MqttMessage SparkplugNode::deviceDeath(const QString& name, const QDateTime& now)
{
    device(name).alive = false;
    SparkplugPayload payload;
    payload.sent = payload.measured = now;
    payload.seq = nextSeq();
    return {topic("DDEATH", name), encoded(payload)};
}

std::vector<MqttMessage> SparkplugNode::setGripper(const QString& serial, const QDateTime& now)
{
    const QString name = serial.isEmpty() ? QString() : deviceName(serial);
    if (name == m_present)
        return {};
    const QString gone = std::exchange(m_present, name);
    if (!m_born)
        return {};
    std::vector<MqttMessage> messages;
    if (!gone.isEmpty() && device(gone).alive)
        messages.push_back(deviceDeath(gone, now));
    if (!name.isEmpty() && !device(name).alive)
        messages.push_back(deviceBirth(name, now));
    return messages;
}

std::vector<MqttMessage> SparkplugNode::data(const LineReport& report, bool historical, const QDateTime& now)
{
    const QString name = deviceName(report.gripper);
    std::vector<MqttMessage> messages;
    if (!device(name).alive)
        messages.push_back(deviceBirth(name, now));
    Device& told = device(name);
    SparkplugPayload payload;
    payload.sent = now;
    payload.measured = report.result.utc;
    payload.seq = nextSeq();
    payload.metrics = resultMetrics(&report, told.firstAlias, MetricsFor::Data);
    for (SparkplugMetric& metric : payload.metrics)
        metric.historical = historical;
    told.last = report;
    messages.push_back({topic("DDATA", name), encoded(payload)});
    return messages;
}

std::vector<MqttMessage> SparkplugNode::settle(const QDateTime& now)
{
    std::vector<MqttMessage> messages;
    for (const auto& known : m_devices)
        if (known.second.alive && known.first != m_present)
            messages.push_back(deviceDeath(known.first, now));
    return messages;
}

} // namespace gripscope
