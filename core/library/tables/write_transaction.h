// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/library/ledger/ledger_writer.h"
#include "core/library/sql/database.h"

namespace gripscope {

/// After a commit: how far the library goes now, to the second place.
void tellWitness(Database& database, const std::optional<ChainEnd>& chain);

/// Commits a transaction whose rows are in the link `chain`. Where a server ended the connection before it
/// answered, it is asked on a new one whether the link is there. StorageUnknown: that one does not come
/// about.
[[nodiscard]] Expected<void> commit(Database& database, Transaction& transaction, const QString& doing,
                                    const std::optional<ChainEnd>& chain);

/// Runs `work` in one write transaction: all of it is stored, or, when it or the commit fails, nothing. What
/// it put in is one link of the ledger; the second place is told afterwards.
template <typename T, typename Work>
Expected<T> writeTo(Database& database, const QString& doing, const Work& work)
{
    ASSIGN_OR_RETURN(auto transaction, Transaction::begin(database, doing));
    Expected<T> result = work();
    if (!result)
        return result;
    ASSIGN_OR_RETURN(const auto chain, continueLedger(database));
    RETURN_IF_ERROR(commit(database, *transaction, doing, chain));
    tellWitness(database, chain);
    return result;
}

} // namespace gripscope
