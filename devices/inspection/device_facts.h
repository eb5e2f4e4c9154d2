// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <cstdint>
#include <vector>

namespace gripscope {

/// Where a gripper hangs on this computer and what its report descriptor is.
struct DeviceFacts {
    QString node;   ///< /dev/hidraw0; empty for one that is not on USB
    QString usbIds; ///< 1209:0001
    std::vector<std::uint8_t> descriptor;
};

/// For an address and the serial number that the gripper gave. Reads the system's device list: not for the
/// screen's thread.
[[nodiscard]] DeviceFacts findDeviceFacts(const QString& address, const QString& serial);

} // namespace gripscope
