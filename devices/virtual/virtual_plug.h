// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/address/device_address.h"

#include <chrono>

namespace gripscope {

/// Virtual grippers that a fault has unplugged and will plug in again. Each connection has a gripper of its
/// own; this is what the next connection must know: that it is not there yet, how far its faults have come,
/// and how many squeezes it has made, since it is not to repeat them. One memory for the whole program, for
/// any thread; two grippers with the same address share a place in it.
namespace virtual_plug {

using Clock = std::chrono::steady_clock;

struct Past {
    double faults_s = 0; ///< of its faults have passed
    std::uint64_t squeezes = 0;
};

/// It is gone until `back`, when its past will be `past`.
void unplug(const VirtualAddress& address, Clock::time_point back, const Past& past);
/// Whether it was unplugged and will be, or is, there again.
[[nodiscard]] bool comesBack(const VirtualAddress& address);
/// Whether it can be connected to.
[[nodiscard]] bool isIn(const VirtualAddress& address);
/// Its past, none for one that was not unplugged; nothing while it is gone. What was known of the unplug is
/// forgotten then: a later connection begins from the beginning.
[[nodiscard]] std::optional<Past> plugIn(const VirtualAddress& address);

} // namespace virtual_plug
} // namespace gripscope
