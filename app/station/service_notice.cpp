// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/station/service_notice.h"

#include <cstddef>
#include <cstring>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

namespace gripscope {

ServiceNotice::ServiceNotice() : m_socket(qgetenv("NOTIFY_SOCKET"))
{
    bool isNumber = false;
    const qlonglong watchdog_us = qgetenv("WATCHDOG_USEC").toLongLong(&isNumber);
    if (isNumber && watchdog_us > 0)
        m_every = std::chrono::microseconds(watchdog_us / 2);
}

void ServiceNotice::send(const QByteArray& state) const
{
    sockaddr_un to{};
    if (m_socket.isEmpty() || m_socket.size() >= qsizetype(sizeof(to.sun_path)))
        return;
    const int socket = ::socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
    if (socket < 0)
        return;
    to.sun_family = AF_UNIX;
    std::memcpy(to.sun_path, m_socket.constData(), std::size_t(m_socket.size()));
    if (to.sun_path[0] == '@') // of the abstract names
        to.sun_path[0] = '\0';
    // systemd that does not take it now is told again by the next one.
    static_cast<void>(
        !::sendto(socket, state.constData(), std::size_t(state.size()), MSG_NOSIGNAL,
                  reinterpret_cast<const sockaddr*>(&to),
                  static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + std::size_t(m_socket.size()))));
    ::close(socket);
}

void ServiceNotice::ready(const QString& status)
{
    m_status = status;
    send("READY=1\nSTATUS=" + status.toUtf8());
}

void ServiceNotice::status(const QString& text)
{
    if (text == m_status)
        return;
    m_status = text;
    send("STATUS=" + text.toUtf8());
}

void ServiceNotice::stopping()
{
    send("STOPPING=1");
}

void ServiceNotice::alive(std::chrono::steady_clock::time_point now)
{
    if (!m_every || now - m_told < *m_every)
        return;
    m_told = now;
    send("WATCHDOG=1");
}

} // namespace gripscope
