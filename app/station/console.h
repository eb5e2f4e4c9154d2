// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <QJsonObject>
#include <QLocalServer>

#include <functional>

namespace gripscope {

/// What a person at this computer asks of a station that runs: a JSON object on a line by a local socket that
/// only the station's own user and group may open, one answered by one. A request: {"command": "arm",
/// "person": .., "secret": ..}; an answer: {"done": true, ..} or {"done": false, "message": ..}.
class Console {
public:
    using Answer = std::function<void(const QJsonObject&)>;
    /// `answer` may be called later, once.
    using Handler = std::function<void(const QJsonObject& request, const Answer& answer)>;

    Console(QString name, Handler handler);
    /// Usage: another station has that socket.
    [[nodiscard]] Expected<void> listen();

private:
    void accept();
    QString m_name;
    Handler m_handler;
    QLocalServer m_server;
};

/// Asks a station that runs here. NotFound: none does.
[[nodiscard]] Expected<QJsonObject> askStation(const QString& name, const QJsonObject& request);

} // namespace gripscope
