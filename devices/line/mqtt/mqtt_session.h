// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/line/mqtt/mqtt_options.h"
#include "devices/line/mqtt/sparkplug_node.h"
#include "devices/line/mqtt/sparkplug_payload.h"

#include <deque>
#include <map>

namespace gripscope {

/// What a session sends by. Numbers are those of MQTT's packets; negative: it was not sent.
class MqttWire {
public:
    virtual ~MqttWire() = default;
    virtual int publish(const MqttMessage& message) = 0;
    virtual int subscribe(const QString& topic) = 0;
    /// Something harmless that the broker answers. It answers in order, so that its answer says that it has
    /// all that was sent before, also what it does not acknowledge by itself.
    virtual int askForReceipt() = 0;
};

/// One session with a broker from its CONNACK on: subscriptions, births, results, what was acknowledged.
/// No thread, no clock, no file: what waits is handed to send(), what may be forgotten is told.
class MqttSession {
public:
    static constexpr std::size_t mostInFlight = 16; ///< results that are not acknowledged yet

    MqttSession(const MqttOptions& options, std::uint8_t birthDeath, MqttWire& wire);

    [[nodiscard]] std::optional<MqttMessage> will() const;
    void connected();
    void subscribed(int packet);
    void heard(const QString& topic, const QByteArray& payload);
    void acknowledged(int packet); ///< a PUBACK, or a receipt

    /// Births, deaths, whatever is due. `newest`: the last result that there is by now; those to it waited
    /// when the session becomes ready.
    void step(const QString& gripper, quint64 newest, const QDateTime& now);
    [[nodiscard]] bool ready() const { return m_ready; }
    [[nodiscard]] bool waitsForHost() const;
    /// The primary host went: the node said so, and the connection is to be ended.
    [[nodiscard]] bool left() const { return m_left; }
    [[nodiscard]] quint64 sentTo() const { return m_sentTo; }
    [[nodiscard]] std::size_t room() const; ///< for send()
    void send(const std::vector<LineReport>& reports, const QDateTime& now);
    /// Results to here may be forgotten; nothing new: the same as before.
    [[nodiscard]] quint64 acknowledgedTo() const { return m_acknowledgedTo; }
    [[nodiscard]] bool allAcknowledged() const { return m_awaited.empty(); }
    void leave(); ///< NDEATH, before the connection is ended

private:
    void publish(const std::vector<MqttMessage>& messages);
    void becomeReady(quint64 newest, const QDateTime& now);

    MqttOptions m_options;
    MqttWire& m_wire;
    std::optional<SparkplugNode> m_node;
    PrimaryHost m_host;
    std::vector<int> m_subscriptions; ///< that are not answered yet
    bool m_connected = false, m_ready = false, m_left = false, m_rebirth = false, m_unsettled = false;
    quint64 m_historicalTo = 0, m_sentTo = 0, m_acknowledgedTo = 0;
    std::map<int, quint64> m_awaited; ///< the result that is acknowledged by a packet, and all before it
    std::deque<quint64> m_inFlight;   ///< results by their sequence
};

} // namespace gripscope
