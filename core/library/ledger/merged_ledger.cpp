// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/ledger/merged_ledger.h"

#include "core/base/words.h"
#include "core/library/ledger/ledger_table.h"
#include "core/library/ledger/merged_rows.h"
#include "core/library/sql/rows.h"

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

QString readingOthers()
{
    return Words::tr("read the ledgers of other stations");
}

} // namespace

Expected<QString> libraryId(Database& database)
{
    constexpr qsizetype digits = 32;
    ASSIGN_OR_RETURN(const auto first, ledger_table::birth(database));
    return first ? QString::fromLatin1(first->hash.toHex().left(digits)) : QString();
}

namespace merged_ledger {

Expected<void> insert(Database& database, const QString& library, const std::vector<LedgerLink>& links)
{
    ASSIGN_OR_RETURN(TableRows table, TableRows::of(database, u"merged_ledger"_s, u"rowid"_s));
    std::vector<TableRows::Row> rows;
    rows.reserve(links.size());
    for (const LedgerLink& link : links)
        rows.push_back(rowWith(table.columns(), {{u"library", library},
                                                 {u"chain", link.chain},
                                                 {u"number", link.number},
                                                 {u"kind", toString(link.kind)},
                                                 {u"format", qint64(link.format)},
                                                 {u"created_utc", link.utc},
                                                 {u"leaves", link.leaves},
                                                 {u"previous_hash", link.previousHash},
                                                 {u"hash", link.hash},
                                                 {u"signer", link.signer},
                                                 {u"signature", link.signature}}));
    return table.insertAll(rows, Words::tr("take the ledger of another station"));
}

Expected<ChainEnd> endOf(Database& database, const LibraryChain& chain)
{
    ChainEnd end;
    end.chain = chain.second;
    Statement query(database, readingOthers(),
                    u"SELECT number, hash FROM merged_ledger WHERE library = ? AND chain = ? ORDER BY number "
                    "DESC LIMIT 1"_s);
    const auto done = query.bind(chain.first).bind(chain.second).forEach([&](Statement& row) {
        end.links = row.takeInteger();
        end.hash = row.takeBytes();
    });
    if (!done)
        return tl::unexpected(done.error());
    return end;
}

Expected<std::map<LibraryChain, ChainEnd>> ends(Database& database)
{
    std::map<LibraryChain, ChainEnd> ends;
    Statement query(database, readingOthers(),
                    u"SELECT l.library, l.chain, l.number, l.hash FROM merged_ledger l JOIN (SELECT library, "
                    "chain, MAX(number) AS number FROM merged_ledger GROUP BY library, chain) e ON e.library "
                    "= l.library AND e.chain = l.chain AND e.number = l.number"_s);
    const auto done = query.forEach([&](Statement& row) {
        const QString library = row.takeText();
        ChainEnd end;
        end.chain = row.takeText();
        end.links = row.takeInteger();
        end.hash = row.takeBytes();
        ends[{library, end.chain}] = end;
    });
    if (!done)
        return tl::unexpected(done.error());
    return ends;
}

Expected<QByteArray> hashOf(Database& database, const LibraryChain& chain, qint64 number)
{
    QByteArray hash;
    Statement query(database, readingOthers(),
                    u"SELECT hash FROM merged_ledger WHERE library = ? AND chain = ? AND number = ?"_s);
    query.bind(chain.first).bind(chain.second).bind(number);
    if (auto done = query.forEach([&](Statement& row) { hash = row.takeBytes(); }); !done)
        return tl::unexpected(done.error());
    return hash;
}

Expected<void> since(Database& database, const LibraryChain& chain, qint64 after, qint64 last,
                     const std::function<void(const LedgerLink&)>& take)
{
    Statement query(
        database, readingOthers(),
        u"SELECT chain, number, kind, format, created_utc, leaves, previous_hash, hash, signer, signature "
        "FROM merged_ledger WHERE library = ? AND chain = ? AND number > ? AND number <= ? ORDER BY number"_s);
    query.bind(chain.first).bind(chain.second).bind(after).bind(last);
    return query.forEach([&](Statement& row) { take(ledger_table::takeLink(row)); });
}

Expected<qint64> ofOtherKinds(Database& database)
{
    if (database.isOnServer()) // a column there takes nothing else
        return 0;
    Statement query(database, readingOthers(),
                    u"SELECT COUNT(*) FROM merged_ledger WHERE typeof(library) || typeof(chain) || "
                    "typeof(number) || typeof(kind) || typeof(format) || typeof(created_utc) <> "
                    "'texttextintegertextintegertext' OR typeof(leaves) || typeof(previous_hash) || "
                    "typeof(hash) || typeof(signer) || typeof(signature) <> 'blobblobblobblobblob'"_s);
    return numberOf(query);
}

} // namespace merged_ledger
} // namespace gripscope
