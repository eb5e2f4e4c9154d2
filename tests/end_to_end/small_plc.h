// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/support/patience.h"

#include <QByteArray>
#include <QTcpServer>
#include <QTcpSocket>

#include <cstdint>
#include <vector>

namespace gripscope::test {

/// A PLC that reads and writes as the manual says.
class SmallPlc {
public:
    bool connectTo(std::uint16_t port)
    {
        m_socket.connectToHost(QStringLiteral("127.0.0.1"), port);
        return m_socket.waitForConnected(longEnough_ms);
    }
    /// The registers 100 to 147; empty: no answer.
    std::vector<std::uint16_t> read()
    {
        const QByteArray answer = ask(QByteArray::fromHex("0400640030"), 2 + 96);
        std::vector<std::uint16_t> words;
        for (qsizetype i = 2; i + 1 < answer.size(); i += 2)
            words.push_back(
                static_cast<std::uint16_t>((std::uint8_t(answer[i]) << 8) | std::uint8_t(answer[i + 1])));
        return words;
    }
    /// All that a PLC writes, with another heartbeat.
    bool write(std::uint16_t trigger, std::uint32_t token, std::uint32_t acknowledge = 0)
    {
        ++m_beat;
        QByteArray request = QByteArray::fromHex("100000000810");
        const auto word = [&request](std::uint32_t value) {
            request += char((value >> 8) & 0xFF);
            request += char(value & 0xFF);
        };
        for (const std::uint32_t value : {std::uint32_t(m_beat), acknowledge >> 16, acknowledge, 0U,
                                          std::uint32_t(trigger), 0U, token >> 16, token})
            word(value);
        return ask(request, 5).size() == 5;
    }

private:
    QByteArray ask(const QByteArray& pdu, qsizetype expected)
    {
        m_socket.write(
            QByteArray::fromHex("000100000000").replace(5, 1, QByteArray(1, char(pdu.size() + 1))) + '\x01' +
            pdu);
        while (m_socket.bytesAvailable() < 7 + expected)
            if (!m_socket.waitForReadyRead(longEnough_ms))
                return {};
        return m_socket.readAll().mid(7);
    }
    QTcpSocket m_socket;
    std::uint16_t m_beat = 0;
};

inline std::uint16_t freePort()
{
    QTcpServer server;
    return server.listen(QHostAddress::LocalHost) ? server.serverPort() : 0;
}

} // namespace gripscope::test
