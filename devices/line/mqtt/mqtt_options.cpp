// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/line/mqtt/mqtt_options.h"

#include "core/base/words.h"

#include <QCryptographicHash>
#include <QFile>
#include <QSysInfo>

#include <algorithm>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

constexpr std::uint16_t plainPort = 1883, tlsPort = 8883;
constexpr qsizetype longestTopic = 1000, longestPassword = 1024;

bool isTopic(const QString& text)
{
    return text.size() <= longestTopic && !text.contains(u'+') && !text.contains(u'#') &&
           !text.contains(u'\0');
}

bool isTopicPart(const QString& text)
{
    return !text.isEmpty() && isTopic(text) && !text.contains(u'/');
}

tl::unexpected<Error> badOption(const Finding& why)
{
    return failure(ErrorCode::Usage, {why});
}

} // namespace

QString MqttOptions::broker() const
{
    return (host.contains(u':') ? u"[%1]:%2"_s : u"%1:%2"_s).arg(host).arg(port);
}

Expected<void> checkOptions(const MqttOptions& options)
{
    if (options.host.trimmed().isEmpty() || options.port == 0)
        return badOption(Words::say("MQTT needs the name or address of a broker, and its port."));
    if (options.jsonTopic.isEmpty() && options.group.isEmpty() && options.node.isEmpty())
        return badOption(
            Words::say("MQTT needs a topic for JSON, or the group and edge node of Sparkplug B."));
    if (!isTopic(options.jsonTopic) || options.jsonTopic.startsWith(u'$') ||
        options.jsonTopic.startsWith("spBv1.0/"_L1))
        return badOption(
            Words::say("\"%1\" is no topic to send to: it must have neither + nor #, and not begin "
                       "with $ or spBv1.0.")
                .arg(options.jsonTopic));
    if (options.group.isEmpty() != options.node.isEmpty())
        return badOption(Words::say("Sparkplug B needs both, a group and an edge node."));
    for (const QString& part : {options.group, options.node, options.primaryHost})
        if (!part.isEmpty() && !isTopicPart(part))
            return badOption(
                Words::say("\"%1\" is no name of Sparkplug B: it must have neither /, + nor #.").arg(part));
    if (!options.passwordFile.isEmpty() && options.user.isEmpty())
        return badOption(Words::say("MQTT needs the name of the user that the password is of."));
    return {};
}

Expected<void> parseBroker(const QString& text, MqttOptions& options)
{
    const qsizetype colon = text.lastIndexOf(u':');
    const bool hasPort =
        colon > 0 && !text.endsWith(u']') && (text.count(u':') == 1 || text.startsWith(u'['));
    bool isPort = true;
    const unsigned port = hasPort ? text.mid(colon + 1).toUInt(&isPort) : options.tls ? tlsPort : plainPort;
    options.host = hasPort ? text.left(colon) : text;
    if (options.host.startsWith(u'[') && options.host.endsWith(u']'))
        options.host = options.host.mid(1, options.host.size() - 2);
    if (!isPort || port == 0 || port > 65535 || options.host.isEmpty())
        return badOption(Words::say("\"%1\" is no HOST:PORT such as broker.example:1883.").arg(text));
    options.port = static_cast<std::uint16_t>(port);
    return {};
}

void setSparkplug(const QString& text, MqttOptions& options)
{
    options.group = text.section(u'/', 0, 0);
    options.node = text.section(u'/', 1);
}

QByteArray clientId(const MqttOptions& options)
{
    // 23 letters and digits, which every broker takes.
    const QString whole = u"%1/%2/%3/%4"_s.arg(options.group, options.node, options.jsonTopic,
                                               QString::fromLatin1(QSysInfo::machineUniqueId()));
    return "gs" + QCryptographicHash::hash(whole.toUtf8(), QCryptographicHash::Sha256).toHex().left(21);
}

Expected<QByteArray> readPassword(const MqttOptions& options)
{
    if (options.passwordFile.isEmpty())
        return QByteArray();
    QFile file(options.passwordFile);
    if (!file.open(QIODevice::ReadOnly))
        return failure(ErrorCode::FileUnreadable, {options.passwordFile, file.errorString()});
    if (file.permissions() & (QFileDevice::ReadOther | QFileDevice::WriteOther))
        return badOption(
            Words::say("Everybody on this computer can read the password in %1. Let only its owner read "
                       "it (chmod 600).")
                .arg(options.passwordFile));
    QByteArray line = file.readLine(longestPassword);
    while (line.endsWith('\n') || line.endsWith('\r'))
        line.chop(1);
    return line;
}

} // namespace gripscope
