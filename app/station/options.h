// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/library/link/plant_link.h"
#include "core/recognition/verdict/verdict.h"
#include "devices/line/modbus_server.h"
#include "devices/line/mqtt/mqtt_options.h"

namespace gripscope {

struct StationOptions {
    QString answer; ///< to be printed instead of anything else: help, version
    /// arm, disarm, stop, status: asked of a station that runs; empty: to be one.
    QString command;
    QString person;  ///< who asks
    QString console; ///< the local socket
    QString library, address, expectedType;
    QStringList types; ///< by number
    std::optional<ModbusServerOptions> modbus;
    std::optional<MqttOptions> mqtt;       ///< where results are sent as well
    std::optional<PlantLinkOptions> plant; ///< the server that the library is kept in step with
    double heartbeat_s = 2;
    VerdictOptions rates;
};

/// Usage, with the option that makes no sense.
[[nodiscard]] Expected<StationOptions> parseStationOptions(const QStringList& arguments);

} // namespace gripscope
