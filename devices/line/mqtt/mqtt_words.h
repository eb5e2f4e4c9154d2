// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/line/clock_standing.h"
#include "core/session/line/line_status.h"
#include "devices/line/mqtt/mqtt_options.h"

namespace gripscope {

/// What libmosquitto and the system say of a connection that did not come about, or broke off.
struct ConnectionFault {
    int code = 0;                    ///< MOSQ_ERR_...
    int systemError = 0;             ///< errno
    std::optional<int> refusal = {}; ///< the code of a CONNACK
    QByteArray complaint = {};       ///< all that TLS said
};
/// In words for a person: what, and what to do.
[[nodiscard]] Error connectionProblem(const MqttOptions& options, const ConnectionFault& fault);

/// How the results fare that go to a broker.
struct MqttLink {
    bool on = false;
    bool connected = false;    ///< a session stands, and takes results
    QDateTime since;           ///< connected, or not
    bool waitsForHost = false; ///< the session stands, and the primary host is not there
    QString broker, host;
    std::size_t waiting = 0;            ///< results that the broker has not acknowledged
    quint64 refused = 0;                ///< results for which there was no room
    bool damaged = false;               ///< some of what waited could not be read
    std::optional<Error> problem;       ///< the last refusal, until a session stands
    std::optional<Error> stored;        ///< why results cannot be kept
    std::optional<ClockStanding> clock; ///< that gives the results their time
};
[[nodiscard]] LineWords mqttWords(const MqttLink& link);

} // namespace gripscope
