// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "devices/acquisition/command_queue.h"

namespace gripscope {

// What a link says to a person of its safety.

/// Why a device that was armed says that it is not, by its own status bits.
[[nodiscard]] QString deviceReason(std::uint16_t status, bool screenStoodStill);
/// What was asked, to follow "the gripper refused to" or "the gripper did not".
[[nodiscard]] QString inWords(const protocol::CommandBody& body);
/// What the device answered, with what its detail adds.
[[nodiscard]] Error refusal(const CommandQueue::Outcome& outcome);

} // namespace gripscope
