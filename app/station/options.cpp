// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/station/options.h"

#include "core/library/library.h"

#include <QCommandLineParser>
#include <QStandardPaths>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

constexpr double shortestHeartbeat_s = 0.2, longestHeartbeat_s = 60;

/// Beside what systemd made for the service, else where the user's sockets are.
QString usualConsole()
{
    const QString given = qEnvironmentVariable("RUNTIME_DIRECTORY");
    if (!given.isEmpty())
        return given + u"/console"_s;
    return QStandardPaths::writableLocation(QStandardPaths::RuntimeLocation) + u"/gripscope-station"_s;
}

void describeOptions(QCommandLineParser& parser)
{
    parser.setApplicationDescription(
        u"gripscope-station inspects the parts that a PLC asks for, without a screen. With a command it asks "
        "a station that runs here: status, stop, disarm, or arm, which only a person at the station can do "
        "(where people are in the library, the PIN or password is asked for)."_s);
    parser.addPositionalArgument(u"command"_s, u"arm, disarm, stop or status."_s, u"[command]"_s);
    parser.addOptions({
        {u"help"_s, u"Says this."_s},
        {u"version"_s, u"Says the version."_s},
        {u"library"_s,
         u"File with the types and squeezes, or postgresql://USER@HOST:PORT/DATABASE (without it: the user's own)."_s,
         u"DB"_s},
        {u"address"_s, u"The gripper, as gripscope-cli devices lists them."_s, u"ADDRESS"_s},
        {u"modbus"_s, u"Listens for a PLC there, such as 127.0.0.1:1502."_s, u"HOST:PORT"_s},
        {u"peers"_s, u"Addresses and networks that may connect, with commas; this computer always may."_s,
         u"LIST"_s},
        {u"mqtt"_s, u"Sends every result to this broker, such as broker.example:1883."_s, u"HOST:PORT"_s},
        {u"mqtt-topic"_s, u"As JSON, on this topic."_s, u"TOPIC"_s},
        {u"sparkplug"_s, u"As Sparkplug B, as this edge node of this group."_s, u"GROUP/NODE"_s},
        {u"primary-host"_s, u"Results wait until this host of Sparkplug is online."_s, u"ID"_s},
        {u"mqtt-tls"_s, u"Over TLS."_s},
        {u"mqtt-ca"_s, u"Authorities that the broker's certificate may be of (without it: the computer's)."_s,
         u"FILE"_s},
        {u"mqtt-user"_s, u"Who the station is for the broker."_s, u"NAME"_s},
        {u"mqtt-password-file"_s,
         u"The first line of this file is the password; only its owner may read it."_s, u"FILE"_s},
        {u"plant"_s,
         u"Keeps the library, a file, in step with that of the plant on a server: "
         "postgresql://USER@HOST:PORT/DATABASE."_s,
         u"ADDRESS"_s},
        {u"heartbeat"_s, u"A PLC whose heartbeat stands still for so long is lost. Default: 2."_s,
         u"SECONDS"_s},
        {u"types"_s, u"Names of types by their number from 1 on, with semicolons."_s, u"LIST"_s},
        {u"expect"_s, u"The type that is expected where a trigger names none."_s, u"NAME"_s},
        {u"false-reject"_s, u"Share of squeezes of types that may be called unknown."_s, u"P"_s},
        {u"wrong-type"_s, u"Share of squeezes of types that may be named another."_s, u"P"_s},
        {u"stranger-accept"_s, u"Share of parts of no type that may be named one."_s, u"P"_s},
        {u"console"_s, u"Local socket for the commands (without it: in the runtime directory)."_s, u"FILE"_s},
        {u"person"_s, u"Who arms (without it: GRIPSCOPE_PERSON, else the user)."_s, u"NAME"_s},
    });
}

Expected<double> numberOf(const QCommandLineParser& parser, const QString& name, double least, double most)
{
    bool isNumber = false;
    const double value = parser.value(name).toDouble(&isNumber);
    if (!isNumber || !(value >= least && value <= most))
        return failure(ErrorCode::Usage,
                       {u"--%1 takes a number from %2 to %3, not \"%4\"."_s.arg(
                           name, QString::number(least), QString::number(most), parser.value(name))});
    return value;
}

Expected<void> takeRates(const QCommandLineParser& parser, VerdictOptions& rates)
{
    const std::pair<QString, double*> all[]{{u"false-reject"_s, &rates.falseReject},
                                            {u"wrong-type"_s, &rates.wrongType},
                                            {u"stranger-accept"_s, &rates.strangerAccept}};
    for (const auto& [name, rate] : all) {
        if (!parser.isSet(name))
            continue;
        ASSIGN_OR_RETURN(*rate, numberOf(parser, name, 1e-5, 0.2));
    }
    return {};
}

QStringList parted(const QString& text, QChar by)
{
    QStringList parts;
    for (const QString& part : text.split(by, Qt::SkipEmptyParts))
        parts << part.trimmed();
    return parts;
}

Expected<void> takeMqtt(const QCommandLineParser& parser, StationOptions& options)
{
    if (!parser.isSet(u"mqtt"_s))
        return {};
    MqttOptions mqtt;
    mqtt.tls = parser.isSet(u"mqtt-tls"_s) || parser.isSet(u"mqtt-ca"_s);
    RETURN_IF_ERROR(parseBroker(parser.value(u"mqtt"_s), mqtt));
    mqtt.caFile = parser.value(u"mqtt-ca"_s);
    mqtt.user = parser.value(u"mqtt-user"_s);
    mqtt.passwordFile = parser.value(u"mqtt-password-file"_s);
    mqtt.jsonTopic = parser.value(u"mqtt-topic"_s);
    setSparkplug(parser.value(u"sparkplug"_s), mqtt);
    mqtt.primaryHost = parser.value(u"primary-host"_s);
    RETURN_IF_ERROR(checkOptions(mqtt));
    options.mqtt = mqtt;
    return {};
}

Expected<void> takePlant(const QCommandLineParser& parser, StationOptions& options)
{
    if (!parser.isSet(u"plant"_s))
        return {};
    PlantLinkOptions plant;
    plant.station = options.library;
    plant.server = parser.value(u"plant"_s);
    RETURN_IF_ERROR(checkOptions(plant));
    options.plant = plant;
    return {};
}

Expected<void> takeLine(const QCommandLineParser& parser, StationOptions& options)
{
    if (parser.isSet(u"modbus"_s)) {
        ASSIGN_OR_RETURN(options.modbus, parseListenAddress(parser.value(u"modbus"_s)));
        options.modbus->peers = parted(parser.value(u"peers"_s), u',');
        RETURN_IF_ERROR(checkOptions(*options.modbus));
    }
    if (parser.isSet(u"heartbeat"_s)) {
        ASSIGN_OR_RETURN(options.heartbeat_s,
                         numberOf(parser, u"heartbeat"_s, shortestHeartbeat_s, longestHeartbeat_s));
    }
    options.types = parted(parser.value(u"types"_s), u';');
    return {};
}

QString personOf(const QCommandLineParser& parser)
{
    for (const QString& name : {parser.value(u"person"_s), qEnvironmentVariable("GRIPSCOPE_PERSON").trimmed(),
                                qEnvironmentVariable("USER")})
        if (!name.isEmpty())
            return name;
    return u"station"_s;
}

} // namespace

Expected<StationOptions> parseStationOptions(const QStringList& arguments)
{
    QCommandLineParser parser;
    describeOptions(parser);
    StationOptions options;
    if (!parser.parse(arguments))
        return failure(ErrorCode::Usage, {parser.errorText()});
    if (parser.isSet(u"help"_s))
        options.answer = parser.helpText();
    else if (parser.isSet(u"version"_s))
        options.answer = u"gripscope-station "_s + QStringLiteral(GRIPSCOPE_VERSION);
    const QStringList commands = parser.positionalArguments();
    if (commands.size() > 1 ||
        (!commands.isEmpty() &&
         !QStringList{u"arm"_s, u"disarm"_s, u"stop"_s, u"status"_s}.contains(commands.first())))
        return failure(ErrorCode::Usage,
                       {u"The command is arm, disarm, stop or status; without one the station runs."_s});
    options.command = commands.value(0);
    options.console = parser.isSet(u"console"_s) ? parser.value(u"console"_s) : usualConsole();
    options.person = personOf(parser);
    options.library = Library::defaultFile();
    if (parser.isSet(u"library"_s)) {
        ASSIGN_OR_RETURN(options.library, Library::placeFrom(parser.value(u"library"_s)));
    }
    options.address = parser.value(u"address"_s);
    options.expectedType = parser.value(u"expect"_s);
    RETURN_IF_ERROR(takeRates(parser, options.rates));
    RETURN_IF_ERROR(takeLine(parser, options));
    RETURN_IF_ERROR(takeMqtt(parser, options));
    RETURN_IF_ERROR(takePlant(parser, options));
    if (options.answer.isEmpty() && options.command.isEmpty() &&
        (options.address.isEmpty() || !options.modbus))
        return failure(ErrorCode::Usage,
                       {u"--address and --modbus are needed: which gripper, and where a PLC "
                        "finds it."_s});
    return options;
}

} // namespace gripscope
