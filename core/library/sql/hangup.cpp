// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/sql/hangup.h"

#include <sys/socket.h>

namespace gripscope {

void Hangup::hangUp()
{
    const std::lock_guard lock(m_mutex);
    for (const int socket : m_sockets)
        ::shutdown(socket, SHUT_RDWR);
}

void Hangup::hangUpForGood()
{
    {
        const std::lock_guard lock(m_mutex);
        m_forGood = true;
    }
    hangUp();
}

void Hangup::note(int socket)
{
    const std::lock_guard lock(m_mutex);
    m_sockets.insert(socket);
    if (m_forGood)
        ::shutdown(socket, SHUT_RDWR);
}

void Hangup::forget(int socket)
{
    const std::lock_guard lock(m_mutex);
    m_sockets.erase(socket);
}

} // namespace gripscope
