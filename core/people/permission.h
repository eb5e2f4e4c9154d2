// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/people/person.h"

namespace gripscope {

/// What asks for a supervisor once people are in a library: what decides about parts that others squeeze, and
/// who may decide. Squeezing, inspecting and enrolling at the gripper are everybody's.
enum class Permission {
    ChangeRates,        ///< that verdicts are held to
    ChangeLimits,       ///< a recipe with its force and travel limits, of a type that is there
    ApproveTypes,       ///< also with the examples
    ChangeTypes,        ///< rename, merge, split, retire, put back, restore a version
    DropSqueezes,       ///< out of a type
    EnrollFiles,        ///< squeezes that nobody here has seen
    AcceptCalibrations, ///< and what else is measured of a gripper's channels
    ManagePeople,
    ChangeSettings
};

/// Supervisors may everything, operators nothing of this.
[[nodiscard]] bool mayDo(Role role, Permission permission);
/// "Approving a type": the beginning of a sentence.
[[nodiscard]] QString inWords(Permission permission);
/// "approve_types": in the audit trail.
[[nodiscard]] QString toString(Permission permission);

} // namespace gripscope
