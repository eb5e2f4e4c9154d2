// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/gripper_return.h"
#include "devices/virtual/virtual_plug.h"

#include <functional>

namespace gripscope {

/// A virtual gripper that its faults plug in again.
class VirtualReturn : public GripperReturn {
public:
    using PortMaker = std::function<std::unique_ptr<GripperPort>()>;
    VirtualReturn(VirtualAddress address, PortMaker makePort)
        : m_address(std::move(address)), m_makePort(std::move(makePort))
    {
    }

    [[nodiscard]] std::unique_ptr<GripperPort> take() override
    {
        const bool there = virtual_plug::comesBack(m_address) && virtual_plug::isIn(m_address);
        return there ? m_makePort() : nullptr;
    }

private:
    const VirtualAddress m_address;
    const PortMaker m_makePort;
};

} // namespace gripscope
