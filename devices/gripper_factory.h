// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/gripper_port.h"

#include <QString>

#include <vector>

namespace gripscope {

/// Ports for every kind of address. The virtual gripper always exists; HID grippers come and go.
class DeviceFactory : public GripperPortFactory {
public:
    [[nodiscard]] Expected<std::unique_ptr<GripperPort>> create(const QString& address) override;
};

struct FoundDevice {
    QString address, serial, name, state; ///< state: "available", "no permission"
};
/// The virtual gripper and every gripper on USB-HID, found through the system's device list (never by
/// hid_enumerate, which crashes when a device goes away meanwhile).
[[nodiscard]] std::vector<FoundDevice> findDevices();

} // namespace gripscope
