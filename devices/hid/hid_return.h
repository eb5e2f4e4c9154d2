// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/connection/gripper_return.h"
#include "devices/address/device_address.h"
#include "devices/hid/hid_watcher.h"

#include <chrono>
#include <functional>

namespace gripscope {

/// The node of a gripper that was connected and went away, when it is there again: one with the vendor,
/// product and serial number of `lost`, either at the port it left or not `thereBefore` (instances that were
/// there when it was missed). A gripper without a serial number is known again only at its own port and only
/// when it is the only one of its kind: two of them could have been exchanged.
[[nodiscard]] std::optional<HidNode> returnedNode(const HidAddress& lost, const QString& port,
                                                  const std::vector<HidNode>& nodes,
                                                  const QStringList& thereBefore);

/// Looks out for a gripper on USB-HID: tells of it when it arrives, or when its permissions change, and again
/// a few times when it did not open, since a device may need a moment after it was plugged in.
class HidReturn : public GripperReturn {
public:
    using PortMaker = std::function<std::unique_ptr<GripperPort>(const HidAddress&)>;
    /// `asked` is the address that the person gave, `makePort` makes a port to an address.
    HidReturn(HidAddress asked, AwaitedGripper awaited, PortMaker makePort);
    [[nodiscard]] std::unique_ptr<GripperPort> take() override;

private:
    using Clock = std::chrono::steady_clock;
    [[nodiscard]] std::optional<HidNode> choose(const std::vector<HidNode>& nodes) const;

    HidAddress m_asked;
    AwaitedGripper m_awaited;
    PortMaker m_makePort;
    HidWatcher m_watcher;
    std::optional<QStringList> m_thereBefore;
    std::uint64_t m_triedRevision = 0;
    int m_attempts = 0; ///< with this revision
    Clock::time_point m_nextAttempt;
};

} // namespace gripscope
