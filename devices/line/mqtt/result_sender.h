// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/line/clock_standing.h"
#include "core/session/line/line_report.h"
#include "devices/line/mqtt/mqtt_publisher.h"

#include <QProcess>

#include <chrono>
#include <memory>
#include <optional>

namespace gripscope {

/// Asks chrony once a minute how this computer's clock stands, and waits for no answer: needs an event loop,
/// and poll() now and then. Where chrony is not, nothing is known.
class ClockWatch {
public:
    explicit ClockWatch(QString program = QStringLiteral("chronyc"));
    ~ClockWatch();
    ClockWatch(const ClockWatch&) = delete;
    ClockWatch& operator=(const ClockWatch&) = delete;

    void poll();
    [[nodiscard]] const std::optional<ClockStanding>& standing() const { return m_standing; }

private:
    using WatchClock = std::chrono::steady_clock;
    void take(bool answered);
    QString m_program;
    QProcess m_process;
    std::optional<WatchClock::time_point> m_asked;
    std::optional<ClockStanding> m_standing;
};

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
