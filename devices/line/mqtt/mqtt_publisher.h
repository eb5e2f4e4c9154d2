// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/line/mqtt/mqtt_outbox.h"
#include "devices/line/mqtt/mqtt_words.h"

#include <thread>

namespace gripscope {

/// Sends what an outbox holds to a broker, in a thread of its own, which may wait for the network. Nobody
/// waits for it: one that hangs when it is to go ends by itself later, and sends nothing more.
class MqttPublisher {
public:
    MqttPublisher(const MqttOptions& options, std::shared_ptr<MqttOutbox> outbox);
    ~MqttPublisher(); ///< waits for milliseconds
    MqttPublisher(const MqttPublisher&) = delete;
    MqttPublisher& operator=(const MqttPublisher&) = delete;

    void setGripper(const QString& serial); ///< that is connected; empty: none
    /// Says that the node leaves. True when it did so within this time.
    bool end(std::chrono::milliseconds patience);
    [[nodiscard]] MqttLink link() const;

private:
    struct Shared;
    std::shared_ptr<Shared> d;
    std::thread m_thread;
};

} // namespace gripscope
