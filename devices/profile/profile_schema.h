// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

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

/// What of `document` is not as resources/profiles/gripper_profile.schema.json asks. What is
/// expected is said in the schema's own descriptions.
[[nodiscard]] std::vector<ProfileProblem> checkAgainstSchema(const QJsonObject& document);

/// The text of the schema.
[[nodiscard]] QByteArray profileSchema();

/// `container`'s pointer and one step further, escaped.
[[nodiscard]] QString jsonPointer(const QString& container, const QString& step);

} // namespace gripscope
