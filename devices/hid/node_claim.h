// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "devices/transport/crash_stop.h"

#include <chrono>

namespace gripscope {

/// A device node held by this program alone: two programs that speak to one gripper stop each other's
/// squeezes. The hold is a lock that every Gripscope asks for; a program that asks for none is noticed by the
/// answers to its commands. It ends with the program, however that ends.
class NodeClaim {
public:
    NodeClaim() = default;
    /// DeviceRefused when another program still has it after `patience` (an earlier connection of this
    /// program lets go a moment after it was closed); DevicePermission, DeviceLost.
    [[nodiscard]] static Expected<NodeClaim> take(const QString& path, std::chrono::milliseconds patience);
    NodeClaim(NodeClaim&& other) noexcept;
    NodeClaim& operator=(NodeClaim&& other) noexcept;
    ~NodeClaim();

    /// Writes this to the node when the program crashes.
    void writeOnCrash(const protocol::Report& report) { m_onCrash = CrashStop(m_descriptor, report); }

private:
    explicit NodeClaim(int descriptor) : m_descriptor(descriptor) {}
    int m_descriptor = -1;
    CrashStop m_onCrash; ///< goes before the descriptor is closed
};

} // namespace gripscope
