// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/line/mqtt/host_state.h"

#include "devices/line/mqtt/sparkplug_names.h"

#include <QJsonDocument>
#include <QJsonObject>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

constexpr qsizetype longestState = 4096;

} // namespace

std::optional<HostState> decodedHostState(const QByteArray& bytes)
{
    if (bytes.size() > longestState)
        return {};
    const QJsonObject object = QJsonDocument::fromJson(bytes).object();
    const QJsonValue online = object["online"_L1], timestamp = object["timestamp"_L1];
    if (!online.isBool() || !timestamp.isDouble() || timestamp.toInteger(-1) < 0)
        return {};
    return HostState{online.toBool(), timestamp.toInteger()};
}

QString hostStateTopic(const QString& host)
{
    return u"%1/STATE/%2"_s.arg(QString::fromLatin1(sparkplug_name::space), host);
}

void PrimaryHost::hear(const HostState& state)
{
    if (!m_last || state.timestamp >= m_last->timestamp)
        m_last = state;
}

} // namespace gripscope
