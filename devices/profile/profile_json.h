// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/profile/gripper_profile.h"
#include "devices/profile/profile_schema.h"

namespace gripscope {

/// A profile read from JSON, or what is wrong with it: one of the two is empty.
struct ProfileReading {
    std::optional<GripperProfile> profile;
    std::vector<ProfileProblem> problems;
};
[[nodiscard]] ProfileReading readProfile(const QByteArray& json);

/// The bytes of a file that may be a profile, which is no larger than 1 MB. FileUnreadable.
[[nodiscard]] Expected<QByteArray> readProfileBytes(const QString& file);
/// FileUnreadable, or BadInput with the first of the problems.
[[nodiscard]] Expected<GripperProfile> readProfileFile(const QString& file);
/// BadInput with the place FILE#/fields/force/byte (or FILE:LINE:COLUMN), what was found, what was expected.
[[nodiscard]] Error toError(const ProfileProblem& problem, const QString& file);

/// The document that readProfile() gives the same profile for.
[[nodiscard]] QByteArray writeProfile(const GripperProfile& profile);

} // namespace gripscope
