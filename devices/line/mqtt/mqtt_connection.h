// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/line/mqtt/mqtt_session.h"

#include <memory>

namespace gripscope {

/// A connection to a broker by libmosquitto, made anew for each session so that nothing of the one before is
/// sent in it. All on the thread that calls; its events go to the session while turn() runs.
class MqttConnection : public MqttWire {
public:
    explicit MqttConnection(const MqttOptions& options);
    ~MqttConnection() override;
    MqttConnection(const MqttConnection&) = delete;
    MqttConnection& operator=(const MqttConnection&) = delete;

    /// Begins to connect. May wait for the name of the host to be found. The errors here and of turn() say
    /// what the broker or the network refuses, and what to do.
    [[nodiscard]] Expected<void> open(MqttSession& session);
    /// Waits for the network, for `wakeDescriptor` to be readable or for the time to pass; does what is due.
    [[nodiscard]] Expected<void> turn(int wakeDescriptor, std::chrono::milliseconds most);
    void close(); ///< DISCONNECT, so that no will is sent

    int publish(const MqttMessage& message) override;
    int subscribe(const QString& topic) override;
    int askForReceipt() override;

private:
    struct Private;
    std::unique_ptr<Private> d;
};

} // namespace gripscope
