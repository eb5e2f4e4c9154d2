// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/tables/permission_check.h"

#include "core/base/words.h"
#include "core/library/tables/person_table.h"
#include "core/library/tables/policy_table.h"

namespace gripscope {

namespace {

Expected<bool> holds(Database& database, const Authority& authority, Permission permission,
                     ArmingPolicy arming)
{
    ASSIGN_OR_RETURN(const auto person, person_table::find(database, authority.personId()));
    return person && person->person.active && mayDo(person->person.role, permission, arming);
}

} // namespace

Expected<std::vector<Authority>> whoMay(Database& database, Permission permission)
{
    ASSIGN_OR_RETURN(const auto arming, policy_table::arming(database));
    const Acting& acting = database.acting();
    std::vector<Authority> asked;
    if (acting.granted && acting.granted->permission == permission)
        asked.push_back(acting.granted->by);
    if (acting.signedIn)
        asked.push_back(*acting.signedIn);
    std::vector<Authority> allowed;
    for (const Authority& authority : asked) {
        ASSIGN_OR_RETURN(const bool may, holds(database, authority, permission, arming));
        if (may)
            allowed.push_back(authority);
    }
    return allowed;
}

Expected<void> requirePermission(Database& database, Permission permission)
{
    ASSIGN_OR_RETURN(const auto anybody, person_table::isAnybodyThere(database));
    if (!anybody)
        return {};
    ASSIGN_OR_RETURN(const auto arming, policy_table::arming(database));
    ASSIGN_OR_RETURN(const auto allowed, whoMay(database, permission));
    if (!allowed.empty())
        return {};
    if (mayDo(Role::Operator, permission, arming))
        return failure(ErrorCode::Usage,
                       {Words::tr("%1 needs somebody who has signed in. Sign in, then try again.")
                            .arg(inWords(permission))});
    return failure(ErrorCode::Usage,
                   {Words::tr("%1 needs a supervisor. Nothing was changed; ask one to authorise it.")
                        .arg(inWords(permission))});
}

} // namespace gripscope
