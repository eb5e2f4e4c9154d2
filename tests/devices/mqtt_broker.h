// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/support/patience.h"

#include <QFile>
#include <QProcess>
#include <QTcpServer>
#include <QTcpSocket>
#include <QTemporaryDir>
#include <QTest>

#include <pwd.h>
#include <unistd.h>

namespace gripscope::test {

/// A real mosquitto on a free port of the loopback, as the user of the test, with all that it keeps in a
/// temporary folder.
class Broker {
public:
    explicit Broker(const QByteArray& more = "allow_anonymous true\n")
    {
        QTcpServer free;
        free.listen(QHostAddress::LocalHost, 0);
        m_port = free.serverPort();
        free.close();
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
        QTcpSocket socket;
        socket.connectToHost(QHostAddress(QHostAddress::LocalHost), m_port);
        return socket.waitForConnected(20);
    }
    QTemporaryDir m_folder;
    std::uint16_t m_port = 0;
    QProcess m_process;
};

} // namespace gripscope::test
