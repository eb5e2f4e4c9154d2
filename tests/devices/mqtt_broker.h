// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/support/patience.h"

#include <QFile>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

#include <arpa/inet.h>
#include <pwd.h>
#include <sys/socket.h>
#include <unistd.h>

namespace gripscope::test {

/// A real mosquitto on a free port of the loopback, as the user of the test, with all that it keeps in a
/// temporary folder.
class Broker {
public:
    explicit Broker(const QByteArray& more = "allow_anonymous true\n")
    {
        m_port = freePort();
        QFile file(m_folder.filePath(QStringLiteral("mosquitto.conf")));
        if (!file.open(QIODevice::WriteOnly))
            qFatal("no configuration for mosquitto");
        file.write("listener " + QByteArray::number(m_port) + " 127.0.0.1\n" + "user " +
                   getpwuid(geteuid())->pw_name +
                   "\nset_tcp_nodelay true\npersistence true\nautosave_interval 0\nmax_queued_messages "
                   "0\npersistence_location " +
                   m_folder.path().toLocal8Bit() + "/\nlog_dest file " +
                   m_folder.filePath(QStringLiteral("log")).toLocal8Bit() + "\n" + more);
    }
    ~Broker() { stop(); }
    Broker(const Broker&) = delete;
    Broker& operator=(const Broker&) = delete;

    [[nodiscard]] bool start()
    {
        m_process.setProgram(QStringLiteral("/usr/sbin/mosquitto"));
        m_process.setArguments({QStringLiteral("-c"), m_folder.filePath(QStringLiteral("mosquitto.conf"))});
        m_process.start();
        return m_process.waitForStarted(int(patience.count())) &&
               QTest::qWaitFor([this] { return listens(); }, int(patience.count()));
    }
    void stop()
    {
        m_process.terminate();
        m_process.waitForFinished(int(patience.count()));
    }
    [[nodiscard]] std::uint16_t port() const { return m_port; }
    [[nodiscard]] QString path(const QString& name) const { return m_folder.filePath(name); }

private:
    [[nodiscard]] bool listens() const
    {
        const int socket = ::socket(AF_INET, SOCK_STREAM, 0);
        sockaddr_in address = loopback(m_port);
        const bool connected =
            ::connect(socket, reinterpret_cast<const sockaddr*>(&address), sizeof(address)) == 0;
        ::close(socket);
        return connected;
    }
    [[nodiscard]] static sockaddr_in loopback(std::uint16_t port)
    {
        sockaddr_in address{};
        address.sin_family = AF_INET;
        address.sin_port = htons(port);
        address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        return address;
    }
    [[nodiscard]] static std::uint16_t freePort()
    {
        const int socket = ::socket(AF_INET, SOCK_STREAM, 0);
        sockaddr_in address = loopback(0);
        socklen_t size = sizeof(address);
        if (::bind(socket, reinterpret_cast<const sockaddr*>(&address), size) != 0 ||
            ::getsockname(socket, reinterpret_cast<sockaddr*>(&address), &size) != 0)
            qFatal("no free port");
        ::close(socket);
        return ntohs(address.sin_port);
    }
    QTemporaryDir m_folder;
    std::uint16_t m_port = 0;
    QProcess m_process;
};

} // namespace gripscope::test
