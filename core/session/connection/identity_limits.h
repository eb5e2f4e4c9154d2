// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/connection/gripper_port.h"

#include <optional>

namespace gripscope {

/// What a gripper says of itself that no gripper is (recording_limits.h), in words; nothing where all is
/// well. Every session counts on it, so whoever connects to a gripper or reads what one sent asks first.
[[nodiscard]] std::optional<Finding> outOfRange(const GripperIdentity& identity);

} // namespace gripscope
