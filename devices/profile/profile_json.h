// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/profile/gripper_profile.h"

#include <QJsonObject>
#include <QString>

#include <vector>

namespace gripscope {

/// One thing that is wrong with a profile.
struct ProfileProblem {
    QString pointer; ///< JSON pointer (RFC 6901), "/fields/force/byte"; ":LINE:COLUMN" where it is no JSON
    QString found, expected;
    friend bool operator==(const ProfileProblem&, const ProfileProblem&) = default;
};

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

/// What of `document` is not as resources/profiles/gripper_profile.schema.json asks. What is
/// expected is said in the schema's own descriptions.
[[nodiscard]] std::vector<ProfileProblem> checkAgainstSchema(const QJsonObject& document);

/// The text of the schema.
[[nodiscard]] QByteArray profileSchema();

/// `container`'s pointer and one step further, escaped.
[[nodiscard]] QString jsonPointer(const QString& container, const QString& step);

/// What is wrong with `profile` that a schema cannot say: fields beyond the report or over each other, units
/// that are not known, bits that a number does not have. Empty: the profile can be used.
[[nodiscard]] std::vector<ProfileProblem> findProfileProblems(const GripperProfile& profile);

} // namespace gripscope
