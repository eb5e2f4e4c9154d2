// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDateTime>
#include <QString>

#include <optional>

namespace gripscope {

/// What somebody may do; see permission.h.
enum class Role { Operator, Supervisor };
[[nodiscard]] QString toString(Role role); ///< "operator", "supervisor": in files and documents
[[nodiscard]] std::optional<Role> roleFromString(const QString& text);
[[nodiscard]] QString inWords(Role role);

/// Somebody who can sign in, as the newest row about them says. Never deleted: who has left is not active.
struct Person {
    QString id, name;
    Role role = Role::Operator;
    bool active = true;
    QDateTime since; ///< of that row
    friend bool operator==(const Person&, const Person&) = default;
};

} // namespace gripscope
