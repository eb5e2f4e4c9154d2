// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/store/audit_witness.h"
#include "core/store/database.h"

namespace gripscope {

/// Runs `work` in one write transaction: all of it is stored, or, when it or the commit fails, nothing. What
/// it added to the audit trail is told to the second place afterwards.
template <typename T, typename Work>
Expected<T> writeTo(Database& database, const QString& doing, const Work& work)
{
    auto transaction = Transaction::begin(database, doing);
    if (!transaction)
        return tl::unexpected(transaction.error());
    database.setNewAuditHead({});
    Expected<T> result = work();
    if (!result)
        return result;
    if (auto done = (*transaction)->commit(); !done)
        return tl::unexpected(done.error());
    if (database.newAuditHead())
        tellWitness(database);
    return result;
}

} // namespace gripscope
