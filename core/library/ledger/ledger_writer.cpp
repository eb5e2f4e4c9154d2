// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/ledger/ledger_writer.h"

#include "core/base/words.h"
#include "core/library/ledger/ledger_leaf.h"
#include "core/library/ledger/ledger_table.h"
#include "core/library/ledger/ledgered_tables.h"
#include "core/library/ledger/row_digest.h"
#include "core/library/ledger/station_key.h"
#include "core/library/sql/statement.h"

#include <algorithm>
#include <map>
#include <span>

namespace gripscope {

namespace {

/// Of the rows that are found: small enough to be read and written at once.
constexpr std::size_t leavesOfLink = 4096;
constexpr std::size_t rowsAtOnce = 500;

tl::unexpected<Error> rowIsGone(const LedgeredTable& table)
{
    return failure(ErrorCode::StorageFailed,
                   {Words::tr("continue its ledger"),
                    Words::tr("a row of %1 is not there although it was just stored").arg(table.name)});
}

LedgerLeaf leafOf(const LedgeredTable& table, const TableRows& rows, const TableRows::Row& row)
{
    LedgerLeaf leaf{table.code, {}, rowDigest(rows.columns(), row)};
    for (std::size_t i = 0; i < row.size(); ++i)
        if (rows.columns()[i].name == table.key)
            leaf.key = row[i];
    return leaf;
}

/// Those of rows that were put in, in that order; each table is read once.
Expected<void> addLeaves(Database& database, std::map<QString, TableRows>& tables,
                         std::span<const InsertedRow> inserted, std::vector<LedgerLeaf>& leaves)
{
    std::map<QString, std::vector<qint64>> numbers;
    for (const InsertedRow& one : inserted)
        if (ledgeredTable(one.table) != nullptr)
            numbers[one.table].push_back(one.rowNumber);
    std::map<QString, std::map<qint64, TableRows::Row>> rows;
    for (const auto& [table, ofTable] : numbers) {
        auto opened = tables.find(table);
        if (opened == tables.end()) {
            ASSIGN_OR_RETURN(TableRows read, TableRows::of(database, table, ledgeredTable(table)->key));
            opened = tables.emplace(table, std::move(read)).first;
        }
        ASSIGN_OR_RETURN(rows[table], opened->second.withRowNumbers(ofTable));
    }
    for (const InsertedRow& one : inserted) {
        const LedgeredTable* table = ledgeredTable(one.table);
        if (table == nullptr)
            continue;
        const auto row = rows[one.table].find(one.rowNumber);
        if (row == rows[one.table].end())
            return rowIsGone(*table);
        leaves.push_back(leafOf(*table, tables.at(one.table), row->second));
    }
    return {};
}

Expected<ChainEnd> addLink(Database& database, LedgerKind kind, const std::vector<LedgerLeaf>& leaves)
{
    const std::optional<StationKey> key = StationKey::own();
    const RowStamp stamp = RowStamp::now();
    LedgerLink link;
    link.signer = key ? key->publicKey() : QByteArray("");
    link.chain = ledgerChain(stamp.station, link.signer);
    ASSIGN_OR_RETURN(const LedgerHead last, ledger_table::head(database, link.chain));
    link.number = last.links + 1;
    link.kind = kind;
    link.utc = stamp.utc;
    link.leaves = packed(leaves);
    link.previousHash = last.hash;
    link.hash = linkHash(link, last.signature);
    link.signature = key ? key->sign(link.hash) : QByteArray("");
    RETURN_IF_ERROR(ledger_table::insert(database, link));
    return ChainEnd{link.chain, link.number, link.hash};
}

} // namespace

Expected<std::optional<ChainEnd>> continueLedger(Database& database)
{
    std::vector<LedgerLeaf> leaves;
    std::map<QString, TableRows> tables;
    const std::vector<InsertedRow> inserted = database.takeInserted();
    for (std::size_t first = 0; first < inserted.size(); first += rowsAtOnce)
        RETURN_IF_ERROR(addLeaves(
            database, tables,
            std::span(inserted).subspan(first, std::min(rowsAtOnce, inserted.size() - first)), leaves));
    if (leaves.empty())
        return std::nullopt;
    ASSIGN_OR_RETURN(ChainEnd end, addLink(database, LedgerKind::Written, leaves));
    static_cast<void>(database.takeInserted()); // the link itself
    return end;
}

Expected<void> enterFoundRows(Database& database)
{
    std::vector<LedgerLeaf> leaves;
    std::optional<Error> problem;
    const auto enter = [&] {
        if (const auto added = addLink(database, LedgerKind::Found, leaves); !added)
            problem = added.error();
        leaves.clear();
        return !problem;
    };
    ASSIGN_OR_RETURN(const auto tables, database.tables());
    for (const LedgeredTable& table : ledgeredTables()) {
        if (!tables.contains(table.name)) // a later step makes it
            continue;
        ASSIGN_OR_RETURN(TableRows rows, TableRows::of(database, table.name, table.key));
        RETURN_IF_ERROR(rows.forEachKey([&](const Cell& key) {
            const auto row = rows.withKey(key);
            if (!row || !*row) {
                problem = row ? rowIsGone(table).value() : row.error();
                return false;
            }
            leaves.push_back(leafOf(table, rows, **row));
            return leaves.size() < leavesOfLink || enter();
        }));
        if (problem)
            return tl::unexpected(*problem);
    }
    if (!leaves.empty() && !enter())
        return tl::unexpected(*problem);
    static_cast<void>(database.takeInserted());
    return {};
}

} // namespace gripscope
