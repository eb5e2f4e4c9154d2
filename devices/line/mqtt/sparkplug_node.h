// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/line/line_report.h"

#include <QByteArray>
#include <QStringList>

#include <cstdint>
#include <map>
#include <vector>

namespace gripscope {

struct MqttMessage {
    QString topic;
    QByteArray payload;
    int qos = 0;
    bool retain = false;
    friend bool operator==(const MqttMessage&, const MqttMessage&) = default;
};

/// The life of an edge node of Sparkplug B 3.0 and of its devices, which are grippers, in one session with a
/// broker: what is to be sent, in its order, with one `seq` over all of it. Values in, messages out: no wire,
/// no clock.
class SparkplugNode {
public:
    /// `birthDeath`: another number in each session, 0 to 255.
    SparkplugNode(QString group, QString node, std::uint8_t birthDeath);

    /// NDEATH, for the broker to send when the session breaks off; sent by the node itself before it leaves.
    [[nodiscard]] MqttMessage death() const;
    /// NBIRTH, and DBIRTH of the gripper that is there and of those that still have results to be told:
    /// first of all in a session, and whenever somebody asks for it again.
    [[nodiscard]] std::vector<MqttMessage> births(const QDateTime& now);
    /// The gripper that is there now; empty: none. DDEATH, DBIRTH, or nothing before births().
    [[nodiscard]] std::vector<MqttMessage> setGripper(const QString& serial, const QDateTime& now);
    /// DDATA, behind a DBIRTH where the gripper has none yet. `historical`: it waited.
    [[nodiscard]] std::vector<MqttMessage> data(const LineReport& report, bool historical,
                                                const QDateTime& now);
    /// DDEATH of grippers that are not there and were only born for results that had waited.
    [[nodiscard]] std::vector<MqttMessage> settle(const QDateTime& now);

    [[nodiscard]] QString commandTopic() const; ///< NCMD
    /// A gripper's serial number as a part of a topic: without `/`, `+`, `#`, and never empty.
    [[nodiscard]] static QString deviceName(const QString& serial);

private:
    struct Device {
        std::uint64_t firstAlias = 0;
        bool alive = false;
        std::optional<LineReport> last; ///< what a birth says are its current values
    };
    [[nodiscard]] QString topic(const char* kind, const QString& device = {}) const;
    [[nodiscard]] MqttMessage deviceBirth(const QString& name, const QDateTime& now);
    [[nodiscard]] MqttMessage deviceDeath(const QString& name, const QDateTime& now);
    [[nodiscard]] Device& device(const QString& name);
    [[nodiscard]] std::uint8_t nextSeq() { return m_seq++; }

    QString m_group, m_node;
    std::uint8_t m_birthDeath;
    std::uint8_t m_seq = 0; ///< 255 is followed by 0, as its type has it
    bool m_born = false;
    QString m_present; ///< the name of the gripper that is there; empty: none
    std::map<QString, Device> m_devices;
};

} // namespace gripscope
