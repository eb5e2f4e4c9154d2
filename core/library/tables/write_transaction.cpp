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

} // namespace gripscope
