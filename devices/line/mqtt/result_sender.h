// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/line/line_report.h"
#include "devices/line/mqtt/clock_watch.h"
#include "devices/line/mqtt/mqtt_publisher.h"

#include <memory>

namespace gripscope {

/// Brings each result of a station's inspections to a broker while it is switched on. No thread, no timer:
/// poll it right behind InspectSession::poll().
class ResultSender {
public:
    ResultSender(const ConnectSession& connection, const InspectSession& inspection);
    /// Results of this library from now on; what still waits of it is sent first. Once more: to another
    /// broker.
    void begin(const MqttOptions& options, const QString& library);
    /// Says that the station leaves. True when it did so within this time, or there was nothing to end.
    bool end(std::chrono::milliseconds patience);
    void poll();
    [[nodiscard]] bool on() const { return m_publisher != nullptr; }
    [[nodiscard]] MqttLink link() const;

private:
    LineReporter m_reporter;
    QString m_library;
    std::shared_ptr<MqttOutbox> m_outbox;
    std::unique_ptr<MqttPublisher> m_publisher;
    ClockWatch m_clock;
};

} // namespace gripscope
