// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/line/clock_standing.h"

#include <QProcess>

#include <chrono>

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

} // namespace gripscope
