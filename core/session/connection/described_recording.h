// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/connection/connect_session.h"

namespace gripscope {

/// A recording without samples that says what measures it: sample time, units and hold of the connected
/// gripper, what is known of its channels (lag, chain, calibration), and in its provenance device, serial,
/// address, firmware, operator and the UTC time, beside what `provenance` says.
[[nodiscard]] Recording describedRecording(const ConnectSession& connection, const QString& operatorName,
                                           QMap<QString, QString> provenance);

} // namespace gripscope
