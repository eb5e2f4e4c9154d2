// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <cstdint>
#include <span>
#include <vector>

namespace gripscope::protocol {

/// An item of a HID report descriptor (Device Class Definition for HID 1.11, section 6.2.2).
struct DescriptorItem {
    QString hex;   ///< its bytes
    int depth = 0; ///< how many collections it stands in
    QString words; ///< "Usage page 0xff00 (vendor-defined)"
};

/// Any report descriptor, item by item; the last one says so when bytes are missing. Report IDs of the
/// Gripscope protocol are named.
[[nodiscard]] std::vector<DescriptorItem> descriptorInWords(std::span<const std::uint8_t> bytes);

} // namespace gripscope::protocol
