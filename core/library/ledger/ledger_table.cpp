// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/ledger/ledger_table.h"

#include "core/base/words.h"
#include "core/library/sql/statement.h"

namespace gripscope::ledger_table {

using namespace Qt::StringLiterals;

namespace {

QString readingLedger()
{
    return Words::tr("read its ledger");
}

} // namespace

LedgerLink takeLink(Statement& row)
{
    LedgerLink link;
    link.chain = row.takeText();
    link.number = row.takeInteger();
    link.kind = ledgerKindFrom(row.takeText());
    link.format = static_cast<int>(row.takeInteger());
    link.utc = row.takeText();
    for (QByteArray* bytes : {&link.leaves, &link.previousHash, &link.hash, &link.signer, &link.signature})
        *bytes = row.takeBytes();
    return link;
}

Expected<void> insert(Database& database, const LedgerLink& link)
{
    Statement row(
        database, Words::tr("continue its ledger"),
        u"INSERT INTO ledger (chain, number, kind, format, created_utc, leaves, previous_hash, hash, "
        "signer, signature) VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?)"_s);
    row.bind(link.chain).bind(link.number).bind(toString(link.kind)).bind(link.format).bind(link.utc);
    for (const QByteArray* bytes :
         {&link.leaves, &link.previousHash, &link.hash, &link.signer, &link.signature})
        row.bindBytes(*bytes);
    return row.run();
}

Expected<LedgerHead> head(Database& database, const QString& chain)
{
    LedgerHead head = emptyLedgerHead();
    Statement query(
        database, readingLedger(),
        u"SELECT number, hash, signature FROM ledger WHERE chain = ? ORDER BY number DESC LIMIT 1"_s);
    const auto done = query.bind(chain).forEach([&](Statement& row) {
        head.links = row.takeInteger();
        head.hash = row.takeBytes();
        head.signature = row.takeBytes();
    });
    if (!done)
        return tl::unexpected(done.error());
    return head;
}

Expected<std::optional<ChainEnd>> birth(Database& database)
{
    std::optional<ChainEnd> first;
    // Not by its time: the clock of a station that came later may be behind.
    Statement query(
        database, readingLedger(),
        u"SELECT chain, number, hash FROM ledger ORDER BY %1 LIMIT 1"_s.arg(Database::orderOfInsertion()));
    const auto done = query.forEach([&](Statement& row) {
        first.emplace();
        first->chain = row.takeText();
        first->links = row.takeInteger();
        first->hash = row.takeBytes();
    });
    if (!done)
        return tl::unexpected(done.error());
    return first;
}

Expected<QByteArray> hashOf(Database& database, const QString& chain, qint64 number)
{
    QByteArray hash;
    Statement query(database, readingLedger(), u"SELECT hash FROM ledger WHERE chain = ? AND number = ?"_s);
    query.bind(chain).bind(number);
    if (auto done = query.forEach([&](Statement& row) { hash = row.takeBytes(); }); !done)
        return tl::unexpected(done.error());
    return hash;
}

LinkHash hashesOf(Database& database)
{
    return [&database](const QString& chain, qint64 number) {
        return hashOf(database, chain, number).value_or(QByteArray());
    };
}

Expected<std::map<QString, ChainEnd>> ends(Database& database)
{
    std::map<QString, ChainEnd> ends;
    // From chain to chain by the key, since there may be millions of links.
    for (QString chain;;) {
        QString next;
        Statement query(database, readingLedger(),
                        u"SELECT chain FROM ledger WHERE chain > ? ORDER BY chain LIMIT 1"_s);
        RETURN_IF_ERROR(query.bind(chain).forEach([&](Statement& row) { next = row.takeText(); }));
        if (next.isEmpty())
            return ends;
        ASSIGN_OR_RETURN(const LedgerHead last, head(database, next));
        ends[next] = {next, last.links, last.hash};
        chain = next;
    }
}

Expected<void> forEach(Database& database, const std::function<void(const LedgerLink&)>& take)
{
    Statement query(database, readingLedger(),
                    u"SELECT chain, number, kind, format, created_utc, leaves, previous_hash, hash, signer, "
                    "signature FROM ledger ORDER BY chain, number"_s);
    return query.forEach([&](Statement& row) { take(takeLink(row)); });
}

Expected<void> since(Database& database, const QString& chain, qint64 after, qint64 last,
                     const std::function<void(const LedgerLink&)>& take)
{
    Statement query(database, readingLedger(),
                    u"SELECT chain, number, kind, format, created_utc, leaves, previous_hash, hash, signer, "
                    "signature FROM ledger WHERE chain = ? AND number > ? AND number <= ? ORDER BY number"_s);
    return query.bind(chain).bind(after).bind(last).forEach([&](Statement& row) { take(takeLink(row)); });
}

Expected<QStringList> ofOtherKinds(Database& database)
{
    QStringList links;
    if (database.isOnServer()) // a column there takes nothing else
        return links;
    Statement query(database, readingLedger(),
                    u"SELECT chain, number FROM ledger WHERE typeof(chain) || typeof(number) || typeof(kind) "
                    "|| typeof(format) || typeof(created_utc) <> 'textintegertextintegertext' OR "
                    "typeof(leaves) || typeof(previous_hash) || typeof(hash) || typeof(signer) || "
                    "typeof(signature) <> 'blobblobblobblobblob'"_s);
    const auto done = query.forEach([&](Statement& row) {
        const QString chain = row.takeText();
        links += u"%1/%2"_s.arg(chain).arg(row.takeInteger());
    });
    if (!done)
        return tl::unexpected(done.error());
    return links;
}

} // namespace gripscope::ledger_table
