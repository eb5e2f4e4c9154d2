// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

namespace gripscope::cli {

/// From now on SIGINT, SIGTERM and SIGHUP stop the gripper and are noted, so that the command can end in
/// order.
void catchInterrupts();
[[nodiscard]] bool interrupted();

/// Calls `poll` every half millisecond until `done`, an interrupt, or `seconds` have passed. True when done.
/// The sessions have their own time limits; this one only keeps a fault in them from hanging the program.
[[nodiscard]] bool drive(const std::function<void()>& poll, const std::function<bool()>& done,
                         double seconds);

} // namespace gripscope::cli
