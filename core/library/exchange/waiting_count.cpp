// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/exchange/waiting_count.h"

#include "core/library/ledger/ledger_leaf.h"
#include "core/library/ledger/ledger_table.h"
#include "core/library/ledger/ledgered_tables.h"

#include <algorithm>

namespace gripscope {

namespace {

qint64 inspectionsIn(const LedgerLink& link)
{
    static const quint8 inspections = ledgeredTable(QStringLiteral("inspections"))->code;
    const auto leaves = unpackedLeaves(link.leaves);
    return leaves ? std::ranges::count(*leaves, inspections, &LedgerLeaf::table) : 0;
}

} // namespace

Expected<void> WaitingCount::countOn(Database& station, const QString& name, qint64 last, Chain& chain)
{
    return ledger_table::since(station, name, chain.counted, last, [&chain](const LedgerLink& link) {
        chain.counted = link.number;
        if (const qint64 inspections = inspectionsIn(link); inspections > 0)
            chain.withResults.emplace_back(link.number, inspections);
    });
}

Expected<Waiting> WaitingCount::count(Database& station, const DeliveredLinks& delivered)
{
    Waiting waiting;
    ASSIGN_OR_RETURN(const auto ends, ledger_table::ends(station));
    for (const auto& [name, end] : ends) {
        Chain& chain = m_chains[name];
        const auto known = delivered.find(name);
        const qint64 mark = known == delivered.end() ? 0 : known->second;
        if (mark < std::exchange(chain.mark, mark))
            chain = {}; // an older copy of the server's library was put back
        chain.counted = std::max(chain.counted, mark);
        RETURN_IF_ERROR(countOn(station, name, end.links, chain));
        while (!chain.withResults.empty() && chain.withResults.front().first <= mark)
            chain.withResults.pop_front();
        waiting.links += std::max<qint64>(0, end.links - mark);
        for (const auto& [link, inspections] : chain.withResults)
            waiting.inspections += inspections;
    }
    return waiting;
}

} // namespace gripscope
