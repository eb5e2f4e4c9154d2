// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/merge/taken_news.h"

#include "core/base/words.h"
#include "core/library/ledger/merged_ledger.h"
#include "core/library/sql/statement.h"
#include "core/library/tables/tally_table.h"
#include "core/library/tables/type_writer.h"

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

using LeavesByTable = std::map<quint8, std::vector<NewLeaf>>;

QString comparingUnits()
{
    return Words::tr("compare the units of its types");
}

/// All rows of links that are new; the links themselves are carried along as they are.
Expected<LeavesByTable> takeLinks(Database& source, Database& target, const std::vector<ChainNews>& news)
{
    LeavesByTable leaves;
    for (const ChainNews& chain : news) {
        std::vector<LedgerLink> links;
        RETURN_IF_ERROR(
            forEachLink(source, chain, [&links](const LedgerLink& link) { links.push_back(link); }));
        for (const LedgerLink& link : links) {
            const auto rows = unpackedLeaves(link.leaves);
            if (!rows)
                return failure(ErrorCode::StorageCorrupt,
                               {source.file(), Words::tr("a link of its ledger cannot be read")});
            const bool madeThere = !isOfMerge(*rows);
            for (const LedgerLeaf& leaf : *rows)
                leaves[leaf.table].push_back({chain.library, leaf, madeThere});
        }
        RETURN_IF_ERROR(merged_ledger::insert(target, chain.library, links));
    }
    return leaves;
}

} // namespace

Expected<void> requireComparableTypes(Database& source, Database& target)
{
    using Units = std::pair<QString, QString>;
    const auto unitsOf = [](Database& database) -> Expected<std::vector<Units>> {
        std::vector<Units> units;
        Statement query(database, comparingUnits(),
                        u"SELECT DISTINCT force_unit, position_unit FROM type_versions"_s);
        const auto done = query.forEach([&](Statement& row) {
            const QString force = row.takeText();
            units.emplace_back(force, row.takeText());
        });
        if (!done)
            return tl::unexpected(done.error());
        return units;
    };
    ASSIGN_OR_RETURN(const auto there, unitsOf(source));
    ASSIGN_OR_RETURN(const auto here, unitsOf(target));
    for (const Units& other : there)
        for (const Units& own : here)
            RETURN_IF_ERROR(requireComparableUnits(other.first, other.second, own.first, own.second));
    return {};
}

Expected<TakenNews> takeNews(Database& source, Database& target, const std::vector<ChainNews>& news)
{
    ASSIGN_OR_RETURN(LeavesByTable leaves, takeLinks(source, target, news));
    if (!leaves[ledgeredTable(u"type_versions"_s)->code].empty())
        RETURN_IF_ERROR(requireComparableTypes(source, target));
    ASSIGN_OR_RETURN(const QString sourceId, libraryId(source));
    RowTaker taker(source, sourceId, target);
    RETURN_IF_ERROR(taker.giveVersions(leaves[ledgeredTable(u"library_changes"_s)->code]));
    for (const TakenTable& table : takenTables())
        RETURN_IF_ERROR(taker.take(table, leaves[table.ledgered().code]));
    TakenNews taken{taker.taken(), 0};
    for (const ChainNews& chain : news)
        taken.links += chain.links - chain.after;
    if (taken.rows.byTable.contains(u"inspections"_s))
        RETURN_IF_ERROR(tally_table::keepUp(target));
    return taken;
}

} // namespace gripscope
