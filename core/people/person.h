// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDateTime>
#include <QString>

#include <chrono>
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

/// Tries to sign in as one person since the last right one, or since they were given a new secret.
struct SignInTries {
    /// So many wrong ones are free: fingers in gloves slip.
    static constexpr int free = 5;
    int wrong = 0;
    QDateTime last;

    /// How long after the last one the next may be made: none at first, then 30 s, doubled with each further
    /// wrong try, at most 15 min. A PIN of 6 digits stands 28 years of that.
    [[nodiscard]] std::chrono::seconds wait() const;
    /// What is left of it; a clock that was set back does not shorten it, nor make it longer than wait().
    [[nodiscard]] std::chrono::seconds remaining(const QDateTime& now) const;
};

/// "40 s", "4 min": rounded up.
[[nodiscard]] QString waitInWords(std::chrono::seconds wait);

} // namespace gripscope
