// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/tables/write_transaction.h"

#include "core/library/ledger/ledger_table.h"
#include "core/library/tables/audit_table.h"

namespace gripscope {

void tellWitness(Database& database, const std::optional<ChainEnd>& chain)
{
    LibraryWitness news;
    news.audit = database.newAuditHead();
    if (chain)
        news.chains[chain->chain] = *chain;
    if (news.empty())
        return;
    tellWitness(database.file(), news, [&](LibraryWitness& known) {
        settleRestore(known, ledger_table::hashesOf(database));
        if (known.audit) {
            const auto there = audit_table::hashOf(database, known.audit->entries);
            if (!there || *there != known.audit->hash)
                return false;
        }
        for (const auto& [name, end] : known.chains) {
            const auto there = ledger_table::hashOf(database, name, end.links);
            if (!there || *there != end.hash)
                return false;
        }
        return true;
    });
}

namespace {

/// Behind the lock, so that what the server does with the lost transaction is done.
Expected<bool> hasArrived(Database& database, const QString& doing, const ChainEnd& chain)
{
    ASSIGN_OR_RETURN(const auto alone, Transaction::begin(database, doing));
    ASSIGN_OR_RETURN(const QByteArray hash, ledger_table::hashOf(database, chain.chain, chain.links));
    return hash == chain.hash;
}

} // namespace

Expected<void> commit(Database& database, Transaction& transaction, const QString& doing,
                      const std::optional<ChainEnd>& chain)
{
    const auto done = transaction.commit();
    if (done || !database.isOnServer() || !transaction.isAnswerLost() || !chain)
        return done;
    const Expected<bool> arrived = hasArrived(database, doing, *chain);
    if (!arrived)
        return failure(ErrorCode::StorageUnknown, {doing, arrived.error().argument(1)});
    return *arrived ? Expected<void>() : done;
}

} // namespace gripscope
