// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/library/enrolled_approval.h"

#include "app/cli/library/type_library.h"
#include "app/cli/line/output.h"
#include "core/library/people/people_register.h"

namespace gripscope::cli {

Expected<bool> approveEnrolled(Library& library, const QString& type, const QString& operatorName)
{
    ASSIGN_OR_RETURN(const bool people, library.people().inForce());
    if (people) {
        message(u"%1 is not approved: its parts are not recognised until a supervisor approves it with "
                "\"types approve\"."_qs.arg(type));
        return false;
    }
    ASSIGN_OR_RETURN(const TypeRecord record, requireNamed(library, type));
    RETURN_IF_ERROR(library.approveType(record.id, operatorName));
    message(u"%1 is approved: its parts are recognised."_qs.arg(type));
    return true;
}

} // namespace gripscope::cli
