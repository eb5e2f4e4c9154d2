// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/line/mqtt/mqtt_session.h"

#include "devices/line/mqtt/report_json.h"

#include <algorithm>

namespace gripscope {

MqttSession::MqttSession(const MqttOptions& options, std::uint8_t birthDeath, MqttWire& wire)
    : m_options(options), m_wire(wire)
{
    if (options.sparkplug())
        m_node.emplace(options.group, options.node, birthDeath);
}

std::optional<MqttMessage> MqttSession::will() const
{
    return m_node ? std::optional(m_node->death()) : std::nullopt;
}

void MqttSession::connected()
{
    m_connected = true;
    if (m_node)
        m_subscriptions.push_back(m_wire.subscribe(m_node->commandTopic()));
    if (!m_options.primaryHost.isEmpty())
        m_subscriptions.push_back(m_wire.subscribe(hostStateTopic(m_options.primaryHost)));
}

void MqttSession::subscribed(int packet)
{
    std::erase(m_subscriptions, packet);
}

void MqttSession::heard(const QString& topic, const QByteArray& payload)
{
    if (m_node && topic == m_node->commandTopic()) {
        m_rebirth = m_rebirth || decodedCommand(payload) == NodeCommand::Rebirth;
        return;
    }
    if (m_options.primaryHost.isEmpty() || topic != hostStateTopic(m_options.primaryHost))
        return;
    if (const std::optional<HostState> state = decodedHostState(payload))
        m_host.hear(*state);
}

void MqttSession::acknowledged(int packet)
{
    const auto found = m_awaited.find(packet);
    if (found == m_awaited.end())
        return;
    m_acknowledgedTo = std::max(m_acknowledgedTo, found->second);
    // A broker answers in the order in which it was asked.
    std::erase_if(m_awaited, [this](const auto& one) { return one.second <= m_acknowledgedTo; });
    while (!m_inFlight.empty() && m_inFlight.front() <= m_acknowledgedTo)
        m_inFlight.pop_front();
}

bool MqttSession::waitsForHost() const
{
    return m_connected && m_subscriptions.empty() && !m_options.primaryHost.isEmpty() && !m_host.online();
}

void MqttSession::publish(const std::vector<MqttMessage>& messages)
{
    for (const MqttMessage& message : messages)
        m_wire.publish(message);
}

void MqttSession::becomeReady(quint64 newest, const QDateTime& now)
{
    m_ready = true;
    m_rebirth = false;
    m_historicalTo = newest;
    if (m_node)
        publish(m_node->births(now));
}

void MqttSession::step(const QString& gripper, quint64 newest, const QDateTime& now)
{
    if (!m_connected || m_left || !m_subscriptions.empty())
        return;
    if (m_node)
        publish(m_node->setGripper(gripper, now));
    if (waitsForHost()) {
        if (m_ready)
            leave();
        return;
    }
    if (!m_ready)
        becomeReady(newest, now);
    if (std::exchange(m_rebirth, false) && m_node)
        publish(m_node->births(now));
}

void MqttSession::leave()
{
    m_ready = false;
    m_left = true;
    if (m_node && m_connected)
        publish({m_node->death()});
}

std::size_t MqttSession::room() const
{
    return m_ready ? mostInFlight - std::min(mostInFlight, m_inFlight.size()) : 0;
}

void MqttSession::send(const std::vector<LineReport>& reports, const QDateTime& now)
{
    for (const LineReport& report : reports) {
        const bool historical = report.sequence <= m_historicalTo;
        if (m_node)
            publish(m_node->data(report, historical, now));
        if (!m_options.jsonTopic.isEmpty()) {
            const int packet =
                m_wire.publish({m_options.jsonTopic, reportJson(report, historical), 1, false});
            m_awaited[packet] = report.sequence;
        }
        m_sentTo = report.sequence;
        m_inFlight.push_back(report.sequence);
        m_unsettled = true;
    }
    if (!reports.empty() && m_options.jsonTopic.isEmpty())
        m_awaited[m_wire.askForReceipt()] = m_sentTo;
    if (reports.empty() && std::exchange(m_unsettled, false) && m_node)
        publish(m_node->settle(now));
}

} // namespace gripscope
