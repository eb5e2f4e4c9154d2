// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

namespace gripscope::protocol {

/// The HID report descriptor of a gripper that speaks this protocol (devices/PROTOCOL.md, section 1).
[[nodiscard]] std::vector<std::uint8_t> reportDescriptor();

} // namespace gripscope::protocol
