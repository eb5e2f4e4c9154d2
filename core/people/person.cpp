// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/people/person.h"

#include "core/words.h"

namespace gripscope {

using namespace Qt::StringLiterals;

QString toString(Role role)
{
    return role == Role::Supervisor ? u"supervisor"_s : u"operator"_s;
}

std::optional<Role> roleFromString(const QString& text)
{
    for (const Role role : {Role::Operator, Role::Supervisor})
        if (toString(role) == text)
            return role;
    return {};
}

QString inWords(Role role)
{
    return role == Role::Supervisor ? Words::tr("supervisor") : Words::tr("operator");
}

} // namespace gripscope
