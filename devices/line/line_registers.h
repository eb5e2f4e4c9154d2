// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/line/modbus_frame.h"
#include "devices/line/register_map.h"

#include <array>
#include <memory>

namespace gripscope {

/// The registers over a desk: a read of status and result is one look at it, a write is heartbeat,
/// acknowledge and job in this order. What was written reads back. The result that is wanted (GetResultById)
/// is looked up when it is read: of the newest JobDesk::mostKept, released or not.
class LineRegisters : public RegisterAccess {
public:
    explicit LineRegisters(std::shared_ptr<SharedJobDesk> desk) : m_desk(std::move(desk)) {}
    [[nodiscard]] std::optional<ModbusException> read(int first, std::span<std::uint16_t> values) override;
    [[nodiscard]] std::optional<ModbusException> write(int first,
                                                       std::span<const std::uint16_t> values) override;

private:
    std::shared_ptr<SharedJobDesk> m_desk;
    std::array<std::uint16_t, line_register::commandCount> m_written{};
};

} // namespace gripscope
