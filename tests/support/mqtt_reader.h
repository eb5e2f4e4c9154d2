// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/support/patience.h"

#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QTest>

#include <vector>

namespace gripscope::test {

/// Reads a topic by mosquitto_sub, a client that knows nothing of this program. What comes while the broker
/// is down for a moment is kept for it.
class MqttReader {
public:
    MqttReader(std::uint16_t port, const QString& topic)
    {
        m_process.setProcessChannelMode(QProcess::MergedChannels);
        m_process.start(QStringLiteral("stdbuf"), // each line at once

                        {QStringLiteral("-oL"), QStringLiteral("mosquitto_sub"), QStringLiteral("-h"),
                         QStringLiteral("127.0.0.1"), QStringLiteral("-p"), QString::number(port),
                         QStringLiteral("-t"), topic, QStringLiteral("-q"), QStringLiteral("1"),
                         QStringLiteral("-i"), QStringLiteral("reader"), QStringLiteral("-c"),
                         QStringLiteral("-d")});
    }
    ~MqttReader()
    {
        m_process.kill();
        m_process.waitForFinished(int(patience.count()));
    }
    MqttReader(const MqttReader&) = delete;
    MqttReader& operator=(const MqttReader&) = delete;

    [[nodiscard]] bool subscribed()
    {
        return QTest::qWaitFor([this] { return take().contains("SUBACK"); }, int(patience.count()));
    }
    /// At least so many messages of JSON so far, or fewer where they do not come.
    [[nodiscard]] std::vector<QJsonObject> messages(std::size_t count)
    {
        static_cast<void>(QTest::qWaitFor([&] { return read().size() >= count; }, int(patience.count())));
        return read();
    }

private:
    const QByteArray& take()
    {
        m_said += m_process.readAll();
        return m_said;
    }
    [[nodiscard]] std::vector<QJsonObject> read()
    {
        std::vector<QJsonObject> found;
        for (const QByteArray& line : take().split('\n'))
            if (const QJsonDocument document = QJsonDocument::fromJson(line); document.isObject())
                found.push_back(document.object());
        return found;
    }
    QProcess m_process;
    QByteArray m_said;
};

} // namespace gripscope::test
