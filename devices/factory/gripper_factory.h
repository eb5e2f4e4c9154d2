// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/connection/gripper_port.h"
#include "devices/acquisition/link_limits.h"
#include "devices/hid/hid_discovery.h"
#include "devices/replay/capture_writer.h"

#include <vector>

namespace gripscope {

/// Where the raw reports of every session are kept.
struct KeepSessions {
    QString folder;
    CaptureLimits limits = {};
    bool virtualToo = false; ///< those of the virtual gripper as well
};

/// Ports for every kind of address. The virtual gripper always exists; HID grippers come and go.
class DeviceFactory : public GripperPortFactory {
public:
    [[nodiscard]] Expected<std::unique_ptr<GripperPort>> create(const QString& address) override;
    /// HID grippers come back when they are plugged in, virtual ones by their faults, files never.
    [[nodiscard]] std::unique_ptr<GripperReturn> awaitReturn(const AwaitedGripper& awaited) override;

    /// From the next connection on, unless its address says otherwise (capture=FILE); nothing: not kept.
    void keepSessions(std::optional<KeepSessions> keep) { m_keep = std::move(keep); }
    /// From the next connection on.
    void setLinkLimits(const LinkLimits& limits) { m_limits = limits; }
    /// Of the session that is being kept.
    [[nodiscard]] CaptureStatus captureStatus() const { return m_monitor->status(); }
    /// What made room since this was asked last.
    [[nodiscard]] std::vector<CapturePruning> takePrunings() { return m_monitor->takePrunings(); }

private:
    std::optional<KeepSessions> m_keep;
    LinkLimits m_limits;
    std::shared_ptr<CaptureMonitor> m_monitor = std::make_shared<CaptureMonitor>();
};

struct FoundDevice {
    QString address, serial, name, state; ///< state: "available", "no permission"
    QString port{};    ///< where it is plugged in, when its serial number does not tell it from another
    QString missing{}; ///< without permission: which one is, in words
    QString toAllow{}; ///< without permission: the line that helps, for a terminal
};
/// The virtual gripper, every gripper on USB-HID and every device there that has a profile, found through the
/// system's device list (never by hid_enumerate, which crashes when a device goes away meanwhile).
[[nodiscard]] std::vector<FoundDevice> findDevices();
/// The same from a list of the HID devices there are.
[[nodiscard]] std::vector<FoundDevice> devicesAmong(const std::vector<HidNode>& nodes);

} // namespace gripscope
