// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/line/mqtt/sparkplug_node.h"

#include "devices/line/mqtt/sparkplug_payload.h"

#include <cmath>

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

using MetricValue = SparkplugMetric::Value;

struct MetricOfResult {
    const char16_t* name;
    SparkplugType type;
    MetricValue (*value)(const LineReport& report);
};

MetricValue wordOrNull(const QString& text)
{
    return text.isEmpty() ? MetricValue() : MetricValue(text);
}

template <std::size_t which>
MetricValue quantityOf(const LineReport& report)
{
    const auto& quantity = report.result.quantities[which];
    return quantity && std::isfinite(quantity->value) ? MetricValue(quantity->value) : MetricValue();
}

template <std::size_t which>
MetricValue uncertaintyOf(const LineReport& report)
{
    const auto& quantity = report.result.quantities[which];
    return quantity && quantity->standardUncertainty && std::isfinite(*quantity->standardUncertainty)
               ? MetricValue(*quantity->standardUncertainty)
               : MetricValue();
}

template <typename Word>
MetricValue numberOf(Word word)
{
    return MetricValue(static_cast<quint64>(word));
}

const MetricOfResult metricsOfResult[] = {
    {u"Sequence", SparkplugType::UInt64, [](const LineReport& r) { return MetricValue(r.sequence); }},
    {u"Time", SparkplugType::DateTime,
     [](const LineReport& r) { return numberOf(r.result.utc.toMSecsSinceEpoch()); }},
    {u"Part", SparkplugType::String, [](const LineReport& r) { return wordOrNull(r.part); }},
    {u"Expected Type", SparkplugType::String, [](const LineReport& r) { return wordOrNull(r.expectedType); }},
    {u"Type", SparkplugType::String, [](const LineReport& r) { return wordOrNull(r.typeFound); }},
    {u"Result State", SparkplugType::UInt16, [](const LineReport& r) { return numberOf(r.result.state); }},
    {u"Evaluation", SparkplugType::UInt16, [](const LineReport& r) { return numberOf(r.result.evaluation); }},
    {u"Reason", SparkplugType::UInt16, [](const LineReport& r) { return numberOf(r.result.reason); }},
    {u"Is Partial", SparkplugType::Boolean,
     [](const LineReport& r) { return MetricValue(r.result.partial); }},
    {u"Is Simulated", SparkplugType::Boolean,
     [](const LineReport& r) { return MetricValue(r.result.simulated); }},
    {u"Mass", SparkplugType::Double, quantityOf<0>},
    {u"Mass Standard Uncertainty", SparkplugType::Double, uncertaintyOf<0>},
    {u"Damping", SparkplugType::Double, quantityOf<1>},
    {u"Damping Standard Uncertainty", SparkplugType::Double, uncertaintyOf<1>},
    {u"Stiffness", SparkplugType::Double, quantityOf<2>},
    {u"Stiffness Standard Uncertainty", SparkplugType::Double, uncertaintyOf<2>},
    {u"Clock Offset", SparkplugType::Double,
     [](const LineReport& r) { return r.clock ? MetricValue(r.clock->offset_s) : MetricValue(); }},
    {u"Clock Dispersion", SparkplugType::Double,
     [](const LineReport& r) { return r.clock ? MetricValue(r.clock->dispersion_s) : MetricValue(); }},
};
/// More than there are metrics of a result.
constexpr std::uint64_t aliasesOfDevice = 32;
static_assert(std::size(metricsOfResult) <= aliasesOfDevice);

enum class MetricsFor { Birth, Data };
/// What a result is made of as metrics of a device, in an order that never changes: later ones are added at
/// the end. Aliases are `firstAlias` and the numbers behind it. Without a report every value is null.
std::vector<SparkplugMetric> resultMetrics(const LineReport* report, std::uint64_t firstAlias, MetricsFor use)
{
    std::vector<SparkplugMetric> metrics;
    std::uint64_t alias = firstAlias;
    for (const MetricOfResult& one : metricsOfResult) {
        SparkplugMetric metric;
        if (use == MetricsFor::Birth)
            metric.name = QString::fromUtf16(one.name);
        metric.typed = use == MetricsFor::Birth;
        metric.alias = alias++;
        metric.type = one.type;
        if (report != nullptr)
            metric.value = one.value(*report);
        metrics.push_back(std::move(metric));
    }
    return metrics;
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
