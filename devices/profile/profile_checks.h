// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/profile/gripper_profile.h"
#include "devices/profile/profile_schema.h"

namespace gripscope {

/// What is wrong with `profile` that a schema cannot say: fields beyond the report or over each other, units
/// that are not known, bits that a number does not have. Empty: the profile can be used.
[[nodiscard]] std::vector<ProfileProblem> findProfileProblems(const GripperProfile& profile);

} // namespace gripscope
