// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/store/permission_check.h"

#include "core/store/person_table.h"
#include "core/words.h"

namespace gripscope {

namespace {

Expected<bool> holds(Database& database, const Authority& authority, Permission permission)
{
    const auto person = person_table::find(database, authority.personId());
    if (!person)
        return tl::unexpected(person.error());
    return *person && (*person)->person.active && mayDo((*person)->person.role, permission);
}

} // namespace

Expected<void> requirePermission(Database& database, Permission permission)
{
    const auto anybody = person_table::isAnybodyThere(database);
    if (!anybody)
        return tl::unexpected(anybody.error());
    if (!*anybody)
        return {};
    const Acting& acting = database.acting();
    Expected<bool> may = false;
    if (acting.granted && acting.granted->permission == permission)
        may = holds(database, acting.granted->by, permission);
    if (may && !*may && acting.signedIn)
        may = holds(database, *acting.signedIn, permission);
    if (!may)
        return tl::unexpected(may.error());
    if (*may)
        return {};
    return failure(ErrorCode::Usage,
                   {Words::tr("%1 needs a supervisor. Nothing was changed; ask one to authorise it.")
                        .arg(inWords(permission))});
}

} // namespace gripscope
