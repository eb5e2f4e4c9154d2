// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/library/sql/database.h"
#include "core/library/tables/audit_witness.h"

namespace gripscope {

/// Runs `work` in one write transaction: all of it is stored, or, when it or the commit fails, nothing. What
/// it added to the audit trail is told to the second place afterwards.
template <typename T, typename Work>
Expected<T> writeTo(Database& database, const QString& doing, const Work& work)
{
    ASSIGN_OR_RETURN(auto transaction, Transaction::begin(database, doing));
    database.setNewAuditHead({});
    Expected<T> result = work();
    if (!result)
        return result;
    RETURN_IF_ERROR(transaction->commit());
    if (database.newAuditHead())
        tellWitness(database);
    return result;
}

} // namespace gripscope
