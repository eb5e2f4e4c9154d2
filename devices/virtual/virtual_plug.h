// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/device_address.h"

#include <chrono>

namespace gripscope {

/// Virtual grippers that a fault has unplugged and will plug in again. Each connection has a gripper of its
/// own; this is what the next connection must know: that it is not there yet, and how far its faults have
/// come. One memory for the whole program, for any thread; two grippers with the same address share a place
/// in it.
namespace virtual_plug {

using Clock = std::chrono::steady_clock;

/// It is gone until `back`, when `faults_s` seconds of its faults will have passed.
void unplug(const VirtualAddress& address, Clock::time_point back, double faults_s);
/// Whether it can be connected to.
[[nodiscard]] bool isIn(const VirtualAddress& address);
/// How many seconds of its faults have passed, 0 for one that was not unplugged; nothing while it is gone.
/// What was known of the unplug is forgotten then: a later connection begins from the beginning.
[[nodiscard]] std::optional<double> plugIn(const VirtualAddress& address);

} // namespace virtual_plug
} // namespace gripscope
