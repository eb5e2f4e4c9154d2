// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/line/mqtt/mqtt_words.h"

#include "core/base/words.h"

#include <cerrno>
#include <cmath>
#include <mosquitto.h>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

/// Two results of a line are seldom closer.
constexpr double mayBeOff_s = 1;

Finding refusalWords(const MqttOptions& options, int code)
{
    switch (code) {
    case 1:
        return Words::say("The broker %1 does not speak MQTT 3.1.1.").arg(options.broker());
    case 2:
        return Words::say("The broker %1 refuses this station's name.").arg(options.broker());
    case 3:
        return Words::say("The broker %1 is there, and takes nobody at the moment.").arg(options.broker());
    default: // 4: wrong, 5: not allowed; brokers mix them up
        return options.user.isEmpty()
                   ? Words::say("The broker %1 wants a user and a password.").arg(options.broker())
                   : Words::say("The broker %1 refuses the password, or the user %2.")
                         .arg(options.broker(), options.user);
    }
}

Finding tlsWords(const MqttOptions& options, const QByteArray& complaint)
{
    // OpenSSL itself then only says that verification failed.
    if (complaint.contains("host name") || complaint.contains("hostname"))
        return Words::say("The certificate of the broker %1 is for another name.").arg(options.broker());
    if (complaint.contains("certificate verify failed") || complaint.contains("self signed"))
        return Words::
            say("The certificate of the broker %1 is not trusted: it was not issued by an authority of the "
                "CA file, or is out of date.")
                .arg(options.broker());
    return Words::say("The broker %1 does not speak TLS as it should (%2).")
        .arg(options.broker(), QString::fromUtf8(complaint).trimmed());
}

Finding networkWords(const MqttOptions& options, int systemError)
{
    switch (systemError) {
    case ECONNREFUSED:
        return Words::say("Nothing listens on %1: no broker runs there, or on another port.")
            .arg(options.broker());
    case EHOSTUNREACH:
    case ENETUNREACH:
        return Words::say("No route to %1. Look at cable, switch and address.").arg(options.host);
    case ETIMEDOUT:
        return Words::say("%1 does not answer.").arg(options.broker());
    default:
        return Words::say("The connection to the broker %1 was lost (%2).")
            .arg(options.broker(), systemError == 0 ? u"MQTT"_s : qt_error_string(systemError));
    }
}

} // namespace

Error connectionProblem(const MqttOptions& options, const ConnectionFault& fault)
{
    Finding words;
    if (fault.refusal)
        words = refusalWords(options, *fault.refusal);
    else if (fault.code == MOSQ_ERR_EAI)
        words = Words::say("There is no host called %1.").arg(options.host);
    else if (fault.code == MOSQ_ERR_TLS || (options.tls && !fault.complaint.isEmpty()))
        words = tlsWords(options, fault.complaint);
    else if (fault.code == MOSQ_ERR_INVAL && options.tls)
        words = Words::say("The CA file %1 cannot be read.").arg(options.caFile);
    else
        words = networkWords(options, fault.systemError);
    return {ErrorCode::Usage, {words}};
}

LineWords mqttWords(const MqttLink& link)
{
    LineWords words;
    if (!link.on) {
        words.headline = Words::say("MQTT: off");
        words.well = true;
        return words;
    }
    const QString since = link.since.toLocalTime().toString(u"HH:mm"_s);
    if (link.stored)
        words.problems.push_back(Finding(link.stored->describe()));
    if (link.problem && link.problem != link.stored)
        words.problems.push_back(Finding(link.problem->describe()));
    if (link.waitsForHost)
        words.problems.push_back(
            Words::say("The primary host %1 is not online; results wait for it.").arg(link.host));
    if (link.refused > 0)
        words.problems.push_back(
            Words::say("%1 results were not sent: too many wait already. The library has them.")
                .arg(link.refused));
    if (link.damaged)
        words.problems.push_back(
            Words::say("Some results that waited for the broker could not be read again. The "
                       "library has them."));
    if (link.clock && std::abs(link.clock->offset_s) > mayBeOff_s)
        words.problems.push_back(
            Words::say("The clock of this computer is %1 s off: results have wrong times. "
                       "chronyc makestep sets it.")
                .arg(link.clock->offset_s, 'f', 1));
    words.well = link.connected && words.problems.empty();
    if (!link.since.isValid())
        words.headline = Words::say("MQTT: not connected, %1 waiting").arg(link.waiting);
    else if (link.connected)
        words.headline = Words::say("MQTT: connected since %1, %2 waiting").arg(since).arg(link.waiting);
    else
        words.headline = Words::say("MQTT: not connected since %1, %2 waiting").arg(since).arg(link.waiting);
    return words;
}

} // namespace gripscope
