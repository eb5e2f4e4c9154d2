// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/people/acting.h"
#include "core/people/secret.h"

#include <vector>

namespace gripscope {

class Database;
struct PersonRow;

/// Who may do what in a library, and how they show who they are. While nobody is in it, everything is allowed
/// to everybody; from the first person on, who must be a supervisor, roles are in force and stay so: at least
/// one active supervisor is always left. Everything here is in the audit trail, wrong tries too.
///
/// Whatever hashes (add, setSecret, signIn, authorise) takes a tenth of a second or more. Usage: refused,
/// with the reason in words.
class PeopleRegister {
public:
    explicit PeopleRegister(Database& database) : m_database(&database) {}

    [[nodiscard]] Expected<bool> inForce() const;
    [[nodiscard]] Expected<std::vector<Person>> all() const; ///< active ones first, by name
    /// An active one of that name; NotFound.
    [[nodiscard]] Expected<Person> named(const QString& name) const;
    /// Whether the one who acts may; see requirePermission().
    [[nodiscard]] Expected<void> require(Permission permission) const;

    /// Who may arm the gripper, where people are in the library.
    [[nodiscard]] Expected<ArmingPolicy> arming() const;
    /// For who may manage people.
    [[nodiscard]] Expected<void> setArming(ArmingPolicy policy, const QString& reason = {});
    /// Who may approve a type, where people are in the library.
    [[nodiscard]] Expected<ApprovalPolicy> approval() const;
    /// For who may manage people.
    [[nodiscard]] Expected<void> setApproval(ApprovalPolicy policy, const QString& reason = {});

    [[nodiscard]] Expected<Person> add(const QString& name, Role role, const Secret& secret);
    [[nodiscard]] Expected<void> setRole(const QString& personId, Role role, const QString& reason = {});
    /// By a supervisor, or by the person, who is signed in. Ends a wait after wrong tries.
    [[nodiscard]] Expected<void> setSecret(const QString& personId, const Secret& secret);
    [[nodiscard]] Expected<void> setActive(const QString& personId, bool active);

    /// Wrong tries are counted in the library and make the next ones wait; see SignInTries.
    [[nodiscard]] Expected<Authority> signIn(const QString& personId, const Secret& secret);
    /// The consent of a supervisor to one action of whoever acts.
    [[nodiscard]] Expected<Grant> authorise(const QString& personId, const Secret& secret,
                                            Permission permission);
    /// `idle`: nobody had touched anything for a while.
    [[nodiscard]] Expected<void> signedOut(const Authority& who, bool idle);

private:
    [[nodiscard]] Expected<Authority> check(const QString& personId, const Secret& secret,
                                            const std::optional<Permission>& permission);
    [[nodiscard]] Expected<void> change(const QString& personId, const PersonRow& next,
                                        const char16_t* action, const QString& reason = {});
    Database* m_database;
};

} // namespace gripscope
