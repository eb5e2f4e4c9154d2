// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <mutex>
#include <set>

namespace gripscope {

/// Ends the connections to servers that were opened with it, from any thread. What waits for such a server
/// fails then within milliseconds, as if the server had ended the connection: libpq itself waits without an
/// end for one that takes what it is sent and never answers.
class Hangup {
public:
    Hangup() = default;
    Hangup(const Hangup&) = delete;
    Hangup& operator=(const Hangup&) = delete;

    void hangUp();        ///< those that stand now; later ones are not concerned
    void hangUpForGood(); ///< those too that come about later

    // For a connection.
    void note(int socket);
    void forget(int socket); ///< before it is closed: its number may be given to another file then

private:
    std::mutex m_mutex;
    std::set<int> m_sockets;
    bool m_forGood = false;
};

} // namespace gripscope
