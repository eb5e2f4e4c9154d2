// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/people/person.h"

namespace gripscope {

/// What asks for a supervisor once people are in a library: what decides about parts that others squeeze, and
/// who may decide; and arming, which the library's policy gives to more. Squeezing, inspecting and enrolling
/// at the armed gripper are everybody's.
enum class Permission {
    ChangeRates,        ///< that verdicts are held to
    ChangeLimits,       ///< a recipe with its force and travel limits, of a type that is there
    ApproveTypes,       ///< also with the examples
    ChangeTypes,        ///< rename, merge, split, retire, put back, restore a version
    DropSqueezes,       ///< out of a type
    EnrollFiles,        ///< squeezes that nobody here has seen
    AcceptCalibrations, ///< and what else is measured of a gripper's channels
    ManagePeople,
    ChangeSettings,
    RestoreLibrary, ///< put a backup in the library's place
    AdjustGrippers, ///< to types that were enrolled on another, and to end that
    Arm             ///< the gripper, so that it may move; see ArmingPolicy
};

/// Who may arm a gripper once people are in a library; before that anybody may. From the window and from the
/// command line alike.
enum class ArmingPolicy {
    SignedIn,   ///< everybody who has shown who they are
    Supervisors ///< others with a supervisor's consent, each time
};
[[nodiscard]] QString toString(ArmingPolicy policy); ///< "signed_in", "supervisors": in the library
[[nodiscard]] std::optional<ArmingPolicy> armingPolicyFromString(const QString& text);

/// Who may approve a type once people are in a library.
enum class ApprovalPolicy {
    OnePerson,   ///< any supervisor
    SecondPerson ///< a supervisor who enrolled none of its squeezes
};
[[nodiscard]] QString toString(ApprovalPolicy policy); ///< "one_person", "second_person": in the library
[[nodiscard]] std::optional<ApprovalPolicy> approvalPolicyFromString(const QString& text);

/// Supervisors may everything, operators nothing of this, except to arm where the policy lets them.
[[nodiscard]] bool mayDo(Role role, Permission permission, ArmingPolicy arming = ArmingPolicy::SignedIn);
/// "Approving a type": the beginning of a sentence.
[[nodiscard]] QString inWords(Permission permission);
/// "approve_types": in the audit trail.
[[nodiscard]] QString toString(Permission permission);
[[nodiscard]] std::optional<Permission> permissionFromString(const QString& text);

} // namespace gripscope
