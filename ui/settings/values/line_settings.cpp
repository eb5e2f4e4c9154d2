// SPDX-License-Identifier: GPL-3.0-or-later
// What binds a station to the line around it.
#include "core/library/sql/library_location.h"
#include "ui/settings/values/setting_makers.h"

#include <QCoreApplication>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

std::optional<QString> noServer(const QString& text)
{
    if (text.isEmpty())
        return {};
    const Expected<LibraryLocation> place = LibraryLocation::parse(text);
    if (!place)
        return place.error().describe();
    if (place->server())
        return {};
    return QCoreApplication::translate("gripscope::Setting",
                                       "The plant's library is on a server: postgresql://USER@HOST/NAME.");
}

std::optional<QString> noBroker(const QString& text)
{
    if (!text.contains(u'@') && !text.contains("//"_L1))
        return {};
    return QCoreApplication::translate(
        "gripscope::Setting", "Name the broker alone, such as broker.example:1883. User and password "
                              "have places of their own.");
}

} // namespace

std::vector<Setting> lineSettings()
{
    Setting on =
        switchSetting(setting::lineOn.key, false, SettingGroup::Line,
                      QT_TRANSLATE_NOOP("gripscope::Setting", "A PLC may trigger squeezes"),
                      QT_TRANSLATE_NOOP("gripscope::Setting",
                                        "By Modbus TCP, of a gripper that a person has armed. The register "
                                        "map is in the manual."));
    Setting host =
        textSetting(setting::lineHost.key, SettingKind::Text, SettingGroup::Line,
                    QT_TRANSLATE_NOOP("gripscope::Setting", "Listens on"),
                    QT_TRANSLATE_NOOP("gripscope::Setting",
                                      "A network address of this computer. Empty: 127.0.0.1, which no "
                                      "other computer reaches."));
    Setting port{setting::linePort.key,
                 SettingKind::Number,
                 1502.0,
                 SettingGroup::Line,
                 QT_TRANSLATE_NOOP("gripscope::Setting", "Port"),
                 QT_TRANSLATE_NOOP("gripscope::Setting", "502 needs a right that programs usually lack.")};
    port.least = 1;
    port.most = 65535;
    Setting peers = textSetting(setting::linePeers.key, SettingKind::Text, SettingGroup::Line,
                                QT_TRANSLATE_NOOP("gripscope::Setting", "Who may connect"),
                                QT_TRANSLATE_NOOP("gripscope::Setting",
                                                  "Addresses and networks such as 10.1.2.0/24, parted by "
                                                  "semicolons; this computer always may."));
    Setting types = textSetting(setting::lineTypes.key, SettingKind::Text, SettingGroup::Line,
                                QT_TRANSLATE_NOOP("gripscope::Setting", "Types by number"),
                                QT_TRANSLATE_NOOP("gripscope::Setting",
                                                  "Their names, parted by semicolons: the first is the PLC's "
                                                  "type 1."));
    Setting heartbeat{setting::lineHeartbeat.key,
                      SettingKind::Number,
                      2.0,
                      SettingGroup::Line,
                      QT_TRANSLATE_NOOP("gripscope::Setting", "The PLC is lost"),
                      QT_TRANSLATE_NOOP("gripscope::Setting",
                                        "When its heartbeat stands still for so long: the gripper is then "
                                        "stopped and disarmed.")};
    heartbeat.least = 0.2;
    heartbeat.most = 60;
    heartbeat.decimals = 1;
    heartbeat.unit = "s";
    for (Setting* one : {&on, &host, &port, &peers, &types, &heartbeat})
        one->needsSupervisor = one->needsReason = true;
    for (Setting* one : {&on, &host, &port, &peers})
        one->portable = false; // of this computer and its network
    return {on, host, port, peers, types, heartbeat};
}

std::vector<Setting> brokerSettings()
{
    constexpr SettingGroup group = SettingGroup::Broker;
    std::vector<Setting> all{
        switchSetting(
            setting::mqttOn.key, false, group,
            QT_TRANSLATE_NOOP("gripscope::Setting", "Send every result to a broker"),
            QT_TRANSLATE_NOOP("gripscope::Setting",
                              "Over MQTT. What the broker cannot take yet waits beside the library.")),
        textSetting(
            setting::mqttBroker.key, SettingKind::Text, group,
            QT_TRANSLATE_NOOP("gripscope::Setting", "Broker"),
            QT_TRANSLATE_NOOP("gripscope::Setting",
                              "Its name or address, with a port where that is not 1883, or 8883 over TLS: "
                              "broker.example:1883.")),
        switchSetting(
            setting::mqttTls.key, false, group, QT_TRANSLATE_NOOP("gripscope::Setting", "Over TLS"),
            QT_TRANSLATE_NOOP("gripscope::Setting",
                              "Without it, the password and all results cross the network in the clear.")),
        textSetting(
            setting::mqttCa.key, SettingKind::File, group,
            QT_TRANSLATE_NOOP("gripscope::Setting", "Authority of its certificate"),
            QT_TRANSLATE_NOOP("gripscope::Setting",
                              "A PEM file. Empty: one of the authorities that this computer trusts.")),
        textSetting(
            setting::mqttUser.key, SettingKind::Text, group, QT_TRANSLATE_NOOP("gripscope::Setting", "User"),
            QT_TRANSLATE_NOOP("gripscope::Setting", "Who the station is for the broker. Empty: nobody.")),
        textSetting(setting::mqttPasswordFile.key, SettingKind::File, group,
                    QT_TRANSLATE_NOOP("gripscope::Setting", "File with the password"),
                    QT_TRANSLATE_NOOP("gripscope::Setting",
                                      "Its first line is the password; nobody but its owner may read it.")),
        textSetting(setting::mqttTopic.key, SettingKind::Text, group,
                    QT_TRANSLATE_NOOP("gripscope::Setting", "Topic of JSON"),
                    QT_TRANSLATE_NOOP("gripscope::Setting",
                                      "A message a result, such as plant/results. Empty: no JSON.")),
        textSetting(
            setting::mqttSparkplug.key, SettingKind::Text, group,
            QT_TRANSLATE_NOOP("gripscope::Setting", "Sparkplug group and node"),
            QT_TRANSLATE_NOOP("gripscope::Setting",
                              "As GROUP/NODE, unlike that of any other station. Empty: no Sparkplug B.")),
        textSetting(
            setting::mqttPrimaryHost.key, SettingKind::Text, group,
            QT_TRANSLATE_NOOP("gripscope::Setting", "Primary host"),
            QT_TRANSLATE_NOOP("gripscope::Setting",
                              "Results wait while this host of Sparkplug is not online. Empty: for none."))};
    for (Setting& one : all) {
        if (qstrcmp(one.key, setting::mqttBroker.key) == 0)
            one.refuses = noBroker;
        one.needsSupervisor = one.needsReason = true;
        one.portable = false; // of this station and its network
    }
    return all;
}

std::vector<Setting> plantSettings()
{
    Setting server = textSetting(
        setting::plantServer.key, SettingKind::Text, SettingGroup::Plant,
        QT_TRANSLATE_NOOP("gripscope::Setting", "In step with the server"),
        QT_TRANSLATE_NOOP("gripscope::Setting",
                          "The plant's library: postgresql://USER@HOST/NAME. What is stored here goes there, "
                          "types and calibrations of the plant come from there. Empty: with none."));
    server.refuses = noServer;
    server.needsSupervisor = server.needsReason = true;
    server.portable = false; // of this station and its network
    return {server};
}

} // namespace gripscope
