// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <chrono>
#include <optional>

namespace gripscope {

/// What a service tells systemd, by sd_notify(3)'s datagrams; nothing where it does not run under it.
class ServiceNotice {
public:
    ServiceNotice(); ///< reads NOTIFY_SOCKET and WATCHDOG_USEC
    void ready(const QString& status);
    void status(const QString& text); ///< sent when it changed
    void stopping();
    /// To be called from the loop that is watched; sent at half the time that systemd waits.
    void alive(std::chrono::steady_clock::time_point now = std::chrono::steady_clock::now());

private:
    void send(const QByteArray& state) const;
    QByteArray m_socket;
    QString m_status;
    std::optional<std::chrono::microseconds> m_every;
    std::chrono::steady_clock::time_point m_told;
};

} // namespace gripscope
