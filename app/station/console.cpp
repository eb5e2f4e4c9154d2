// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/station/console.h"

#include <QJsonDocument>
#include <QLocalSocket>
#include <QPointer>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

constexpr int patience_ms = 1000;
constexpr int answerPatience_ms = 15'000; ///< a PIN takes a tenth of a second, arming up to five
constexpr qint64 longestRequest = 4096;
constexpr int mostAtOnce = 4;

QByteArray lineWith(const QJsonObject& object)
{
    return QJsonDocument(object).toJson(QJsonDocument::Compact) + '\n';
}

/// One request of one person.
void serveConsole(QLocalSocket* socket, const Console::Handler& handler)
{
    if (!socket->canReadLine()) {
        if (socket->bytesAvailable() >= longestRequest)
            socket->abort();
        return;
    }
    const QJsonObject request = QJsonDocument::fromJson(socket->readLine(longestRequest)).object();
    handler(request, [where = QPointer<QLocalSocket>(socket)](const QJsonObject& answer) {
        if (!where)
            return;
        where->write(lineWith(answer));
        where->disconnectFromServer();
    });
}

} // namespace

Console::Console(QString name, Handler handler) : m_name(std::move(name)), m_handler(std::move(handler))
{
    m_server.setSocketOptions(QLocalServer::UserAccessOption | QLocalServer::GroupAccessOption);
    m_server.setMaxPendingConnections(mostAtOnce);
    QObject::connect(&m_server, &QLocalServer::newConnection, &m_server, [this] { accept(); });
}

Expected<void> Console::listen()
{
    QLocalSocket other;
    other.connectToServer(m_name);
    if (other.waitForConnected(patience_ms))
        return failure(ErrorCode::Usage, {u"Another station runs here already (%1)."_s.arg(m_name)});
    QLocalServer::removeServer(m_name); // of one that was killed
    if (!m_server.listen(m_name))
        return failure(ErrorCode::FileUnwritable, {m_name, m_server.errorString()});
    return {};
}

void Console::accept()
{
    while (QLocalSocket* socket = m_server.nextPendingConnection()) {
        socket->setReadBufferSize(longestRequest);
        QObject::connect(socket, &QLocalSocket::disconnected, socket, &QObject::deleteLater);
        QObject::connect(socket, &QLocalSocket::readyRead, socket,
                         [this, socket] { serveConsole(socket, m_handler); });
    }
}

Expected<QJsonObject> askStation(const QString& name, const QJsonObject& request)
{
    QLocalSocket socket;
    socket.connectToServer(name);
    if (!socket.waitForConnected(patience_ms))
        return failure(ErrorCode::NotFound, {u"A station that runs here (%1)"_s.arg(name)});
    socket.write(lineWith(request));
    QByteArray answer;
    while (!answer.contains('\n') && socket.waitForReadyRead(answerPatience_ms))
        answer += socket.readAll();
    const QJsonDocument document = QJsonDocument::fromJson(answer);
    if (!document.isObject())
        return failure(ErrorCode::DeviceTimeout,
                       {u"an answer of the station"_s, QString::number(answerPatience_ms / 1000)});
    return document.object();
}

} // namespace gripscope
