// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/people/permission.h"

#include "core/base/words.h"

namespace gripscope {

using namespace Qt::StringLiterals;

QString toString(ArmingPolicy policy)
{
    return policy == ArmingPolicy::Supervisors ? u"supervisors"_s : u"signed_in"_s;
}

std::optional<ArmingPolicy> armingPolicyFromString(const QString& text)
{
    for (const ArmingPolicy policy : {ArmingPolicy::SignedIn, ArmingPolicy::Supervisors})
        if (toString(policy) == text)
            return policy;
    return {};
}

QString toString(ApprovalPolicy policy)
{
    return policy == ApprovalPolicy::SecondPerson ? u"second_person"_s : u"one_person"_s;
}

std::optional<ApprovalPolicy> approvalPolicyFromString(const QString& text)
{
    for (const ApprovalPolicy policy : {ApprovalPolicy::OnePerson, ApprovalPolicy::SecondPerson})
        if (toString(policy) == text)
            return policy;
    return {};
}

bool mayDo(Role role, Permission permission, ArmingPolicy arming)
{
    return role == Role::Supervisor || (permission == Permission::Arm && arming == ArmingPolicy::SignedIn);
}

QString inWords(Permission permission)
{
    switch (permission) {
    case Permission::ChangeRates:
        return Words::tr("Changing the rates of verdicts");
    case Permission::ChangeLimits:
        return Words::tr("Changing a recipe and its limits");
    case Permission::ApproveTypes:
        return Words::tr("Approving a type");
    case Permission::ChangeTypes:
        return Words::tr("Changing enrolled types");
    case Permission::DropSqueezes:
        return Words::tr("Dropping a squeeze");
    case Permission::EnrollFiles:
        return Words::tr("Enrolling squeezes from files");
    case Permission::AcceptCalibrations:
        return Words::tr("Accepting a calibration");
    case Permission::ManagePeople:
        return Words::tr("Managing people");
    case Permission::ChangeSettings:
        return Words::tr("Changing settings");
    case Permission::RestoreLibrary:
        return Words::tr("Putting back a backup of the library");
    case Permission::AdjustGrippers:
        return Words::tr("Adjusting a gripper to types of another");
    case Permission::Arm:
        return Words::tr("Arming the gripper");
    }
    return {};
}

QString toString(Permission permission)
{
    switch (permission) {
    case Permission::ChangeRates:
        return u"change_rates"_s;
    case Permission::ChangeLimits:
        return u"change_limits"_s;
    case Permission::ApproveTypes:
        return u"approve_types"_s;
    case Permission::ChangeTypes:
        return u"change_types"_s;
    case Permission::DropSqueezes:
        return u"drop_squeezes"_s;
    case Permission::EnrollFiles:
        return u"enroll_files"_s;
    case Permission::AcceptCalibrations:
        return u"accept_calibrations"_s;
    case Permission::ManagePeople:
        return u"manage_people"_s;
    case Permission::ChangeSettings:
        return u"change_settings"_s;
    case Permission::RestoreLibrary:
        return u"restore_library"_s;
    case Permission::AdjustGrippers:
        return u"adjust_grippers"_s;
    case Permission::Arm:
        return u"arm"_s;
    }
    return {};
}

std::optional<Permission> permissionFromString(const QString& text)
{
    for (int i = 0; i <= static_cast<int>(Permission::Arm); ++i)
        if (toString(static_cast<Permission>(i)) == text)
            return static_cast<Permission>(i);
    return {};
}

} // namespace gripscope
