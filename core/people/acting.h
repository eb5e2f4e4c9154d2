// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/people/permission.h"

#include <optional>

namespace gripscope {

/// That somebody has shown who they are. Only PeopleRegister makes one, from the right PIN or password; what
/// the person may do is looked up anew with every use.
class Authority {
public:
    [[nodiscard]] const QString& personId() const { return m_person.id; }
    [[nodiscard]] const QString& name() const { return m_person.name; }
    [[nodiscard]] Role role() const { return m_person.role; }

private:
    friend class PeopleRegister;
    explicit Authority(Person person) : m_person(std::move(person)) {}
    Person m_person;
};

/// A supervisor's consent to one action of somebody else.
struct Grant {
    Authority by;
    Permission permission;
};

/// Who works through a library.
struct Acting {
    QString operatorName = {}; ///< as typed, where nobody has to sign in
    std::optional<Authority> signedIn = {};
    std::optional<Grant> granted = {};
};

} // namespace gripscope
