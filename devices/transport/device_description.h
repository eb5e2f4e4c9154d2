// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/connection/gripper_port.h"
#include "devices/protocol/messages.h"
#include "devices/transport/transport.h"

namespace gripscope {

/// What the three feature reports say, as the sessions see it and as the wire needs it.
struct DeviceDescription {
    GripperIdentity identity;
    protocol::MeasurementFeature measurement;
    protocol::LimitsFeature limits;
    /// What it says of itself that keeps it from being armed, with the field's name; it may be listened to.
    std::optional<QString> armingObstacle;

    /// Counts of the force channel for a force in newtons, to the nearest.
    [[nodiscard]] std::int32_t forceCounts(double force_N) const;
    /// The limits in counts, rounded down, at least those of the device.
    [[nodiscard]] protocol::SetLimitsCommand limitCounts(double maxForce_N, double maxTravel_m) const;
};

/// Asks an open transport. A gripper whose units are not known in SI is not commandable: no limit could be
/// checked. DeviceRefused with the report that was not understood, or the transport's error.
[[nodiscard]] Expected<DeviceDescription> describeDevice(Transport& transport, const QString& address);

} // namespace gripscope
