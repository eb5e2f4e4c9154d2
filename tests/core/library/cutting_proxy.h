// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QFile>
#include <QString>
#include <QTemporaryDir>

#include <atomic>
#include <mutex>
#include <poll.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <thread>
#include <unistd.h>
#include <vector>

namespace gripscope::test {

/// Stands between a library and its server, and ends connections where a network would at the worst moment.
class CuttingProxy {
public:
    enum class Cut {
        Nothing,
        Question, ///< a COMMIT does not reach the server
        Answer    ///< a COMMIT is done, and its answer does not come back
    };

    /// `server`: the folder of the server's socket.
    explicit CuttingProxy(const QString& server)
        : m_server(socketIn(server)), m_listening(::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0))
    {
        const sockaddr_un name = nameOf(socketIn(folder()));
        if (::bind(m_listening, reinterpret_cast<const sockaddr*>(&name), sizeof name) != 0 ||
            ::listen(m_listening, 16) != 0)
            qFatal("no socket to listen on");
        m_accepting = std::thread([this] { accept(); });
    }
    ~CuttingProxy()
    {
        m_ending = true;
        m_accepting.join();
        for (std::thread& one : m_connections)
            one.join();
        ::close(m_listening);
    }
    CuttingProxy(const CuttingProxy&) = delete;
    CuttingProxy& operator=(const CuttingProxy&) = delete;

    [[nodiscard]] QString folder() const { return m_folder.path(); }
    void cutNext(Cut cut) { m_cut = cut; } ///< once
    void letNobodyIn(bool nobody) { m_closed = nobody; }

private:
    static QByteArray socketIn(const QString& folder)
    {
        return QFile::encodeName(folder + QStringLiteral("/.s.PGSQL.5432"));
    }
    static sockaddr_un nameOf(const QByteArray& path)
    {
        sockaddr_un name{};
        name.sun_family = AF_UNIX;
        qstrncpy(name.sun_path, path.constData(), sizeof name.sun_path);
        return name;
    }
    void accept()
    {
        while (!m_ending) {
            pollfd news{m_listening, POLLIN, 0};
            if (::poll(&news, 1, 20) != 1)
                continue;
            const int client = ::accept4(m_listening, nullptr, nullptr, SOCK_CLOEXEC);
            if (client < 0)
                continue;
            if (m_closed) {
                ::close(client);
                continue;
            }
            m_connections.emplace_back([this, client] { carry(client); });
        }
    }
    static bool pass(const QByteArray& bytes, int to)
    {
        qsizetype done = 0;
        while (done < bytes.size()) {
            const ssize_t now =
                ::send(to, bytes.constData() + done, size_t(bytes.size() - done), MSG_NOSIGNAL);
            if (now <= 0)
                return false;
            done += now;
        }
        return true;
    }
    static QByteArray read(int from)
    {
        QByteArray bytes(65536, Qt::Uninitialized);
        const ssize_t count = ::recv(from, bytes.data(), size_t(bytes.size()), 0);
        return bytes.first(std::max<ssize_t>(0, count));
    }
    void carry(int client)
    {
        const int server = ::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
        const sockaddr_un name = nameOf(m_server);
        bool open = ::connect(server, reinterpret_cast<const sockaddr*>(&name), sizeof name) == 0;
        while (open && !m_ending) {
            pollfd both[]{{client, POLLIN, 0}, {server, POLLIN, 0}};
            if (::poll(both, 2, 20) <= 0)
                continue;
            if (both[0].revents != 0) {
                const QByteArray bytes = read(client);
                const Cut cut = bytes.contains("COMMIT") ? m_cut.exchange(Cut::Nothing) : Cut::Nothing;
                if (cut == Cut::Question)
                    break;
                open = !bytes.isEmpty() && pass(bytes, server);
                if (cut == Cut::Answer) {
                    read(server); // it is done
                    break;
                }
            }
            if (open && both[1].revents != 0) {
                const QByteArray bytes = read(server);
                open = !bytes.isEmpty() && pass(bytes, client);
            }
        }
        ::close(server);
        ::close(client);
    }

    QTemporaryDir m_folder;
    QByteArray m_server;
    int m_listening;
    std::atomic<Cut> m_cut = Cut::Nothing;
    std::atomic<bool> m_closed = false, m_ending = false;
    std::vector<std::thread> m_connections;
    std::thread m_accepting;
};

} // namespace gripscope::test
