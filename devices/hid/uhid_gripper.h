// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/transport/transport.h"

#include <atomic>

namespace gripscope {

/// Makes a HID device of this computer out of a transport, so that any program finds it where real grippers
/// are: reports of the transport come out of the device, what is written to the device goes to the transport.
///
/// Only where the system has a place for that (Linux: /dev/uhid, the kernel's module uhid).
class UhidGripper {
public:
    /// DevicePermission or DeviceNotFound with what to do, or the transport's error. The transport must be
    /// open.
    [[nodiscard]] static Expected<std::unique_ptr<UhidGripper>> create(std::shared_ptr<Transport> transport);
    /// The same on a file that is open already and speaks the kernel's protocol; it is closed at the end.
    [[nodiscard]] static Expected<std::unique_ptr<UhidGripper>>
    createOn(int file, std::shared_ptr<Transport> transport);
    ~UhidGripper();
    UhidGripper(const UhidGripper&) = delete;
    UhidGripper& operator=(const UhidGripper&) = delete;

    /// Passes reports to and fro until `ending`, or until the transport's device goes away (a fault that was
    /// asked for), which unplugs the HID device.
    [[nodiscard]] Expected<void> serve(const std::atomic<bool>& ending);

private:
    struct Private;
    explicit UhidGripper(std::unique_ptr<Private> made);
    std::unique_ptr<Private> d;
};

} // namespace gripscope
