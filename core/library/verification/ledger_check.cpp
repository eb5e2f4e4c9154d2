// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/words.h"
#include "core/library/ledger/ledger_leaf.h"
#include "core/library/ledger/ledger_table.h"
#include "core/library/ledger/ledgered_tables.h"
#include "core/library/ledger/library_witness.h"
#include "core/library/ledger/row_digest.h"
#include "core/library/ledger/station_key.h"
#include "core/library/sql/database.h"
#include "core/library/verification/library_checks.h"
#include "core/library/verification/library_verification.h"

#include <QSet>
#include <QtEndian>

#include <map>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

void checkOrder(const LedgerLink& link, const LedgerHead& before, QStringList& problems)
{
    if (link.number != before.links + 1)
        problems += Words::tr("the links before it are missing, from number %1 on").arg(before.links + 1);
    else if (link.previousHash != before.hash)
        problems += Words::tr("does not follow from the link before it");
}

void checkContent(const LedgerLink& link, const LedgerHead& before, QStringList& problems)
{
    if (link.format != LedgerLink::newestFormat) {
        problems += Words::tr("is in a format that this program does not know");
        return;
    }
    if (linkHash(link, before.signature) != link.hash)
        problems += Words::tr("was changed: its hash is of something else");
    const QString station = link.chain.left(link.chain.lastIndexOf(u'/'));
    if (link.chain != ledgerChain(station, link.signer))
        problems += Words::tr("is not signed by the key that its chain belongs to");
    else if (!link.signer.isEmpty() && !isSignedBy(link.signer, link.hash, link.signature))
        problems += Words::tr("its signature is not of it");
}

/// Of a row's key: enough that no two are alike by chance.
QByteArray keyDigest(const Cell& key)
{
    const bool isNumber = std::holds_alternative<qint64>(key);
    return digestOf((isNumber ? 'i' : 't') + keyText(key).toUtf8()).first(16);
}

/// Leaves against the rows that they are of, and then rows against the leaves.
class RowCheck {
public:
    RowCheck(Database& database, LibraryVerification& found);
    /// Every leaf of the ledger.
    void take(const LedgerLeaf& leaf);
    /// Whether each row has one leaf; after the last leaf.
    void finish();

private:
    /// A number for a set of keys, whatever their order: the sum of a digest of each, modulo 2^128. Two sets
    /// with the same number and the same size are the same.
    struct Tally {
        quint64 count = 0, high = 0, low = 0;
        void add(const Cell& key);
        friend bool operator==(const Tally&, const Tally&) = default;
    };
    struct Table {
        const LedgeredTable* known = nullptr;
        std::optional<TableRows> rows; ///< none where the table cannot be read
        Tally leaves;
    };
    Table& tableOf(quint8 code);
    void nameRowsWithout(const Table& table);

    Database& m_database;
    LibraryVerification& m_found;
    std::map<quint8, Table> m_tables;
};

void RowCheck::Tally::add(const Cell& key)
{
    const QByteArray digest = keyDigest(key);
    const auto lower = qFromBigEndian<quint64>(digest.constData() + 8);
    ++count;
    low += lower;
    high += qFromBigEndian<quint64>(digest.constData()) + (low < lower ? 1 : 0);
}

RowCheck::RowCheck(Database& database, LibraryVerification& found) : m_database(database), m_found(found)
{
    for (const LedgeredTable& table : ledgeredTables())
        tableOf(table.code);
}

RowCheck::Table& RowCheck::tableOf(quint8 code)
{
    const auto [at, isNew] = m_tables.try_emplace(code);
    Table& table = at->second;
    if (!isNew)
        return table;
    table.known = ledgeredTable(code);
    if (table.known == nullptr)
        return table;
    auto rows = TableRows::of(m_database, table.known->name, table.known->key);
    if (rows)
        table.rows.emplace(std::move(*rows));
    else
        m_found.differs(table.known->name, {}, rows.error().describe());
    return table;
}

void RowCheck::take(const LedgerLeaf& leaf)
{
    Table& table = tableOf(leaf.table);
    if (table.known == nullptr)
        return m_found.differs(u"ledger"_s, keyText(leaf.key),
                               Words::tr("is of a table that this program does not know"));
    table.leaves.add(leaf.key);
    if (!table.rows)
        return;
    const QString name = keyText(leaf.key);
    const auto row = table.rows->withKey(leaf.key);
    ++m_found.rows;
    if (!row)
        m_found.differs(table.known->name, name, row.error().describe());
    else if (!*row)
        m_found.differs(table.known->name, name, Words::tr("is missing"));
    else if (rowDigest(table.rows->columns(), **row) != leaf.digest)
        m_found.differs(table.known->name, name, Words::tr("was changed"));
}

void RowCheck::finish()
{
    for (auto& [code, table] : m_tables) {
        if (!table.rows)
            continue;
        Tally rows;
        const auto read = table.rows->forEachKey([&](const Cell& key) {
            rows.add(key);
            return true;
        });
        if (!read)
            m_found.differs(table.known->name, {}, read.error().describe());
        else if (rows != table.leaves)
            nameRowsWithout(table);
    }
}

void RowCheck::nameRowsWithout(const Table& table)
{
    QSet<QByteArray> leaves;
    const auto read = ledger_table::forEach(m_database, [&](const LedgerLink& link) {
        for (const LedgerLeaf& leaf : unpackedLeaves(link.leaves).value_or(std::vector<LedgerLeaf>{})) {
            if (leaf.table != table.known->code)
                continue;
            const QByteArray digest = keyDigest(leaf.key);
            if (leaves.contains(digest))
                m_found.differs(table.known->name, keyText(leaf.key), Words::tr("is in the ledger twice"));
            leaves.insert(digest);
        }
    });
    if (!read)
        return; // told already
    auto rows = TableRows::of(m_database, table.known->name, table.known->key);
    if (!rows)
        return;
    static_cast<void>(rows->forEachKey([&](const Cell& key) {
        if (!leaves.contains(keyDigest(key)))
            m_found.differs(table.known->name, keyText(key),
                            Words::tr("was put in past this program: the ledger does not know it"));
        return true;
    }));
}

class LedgerCheck {
public:
    LedgerCheck(Database& database, const LibraryWitness& witness, LibraryVerification& found)
        : m_witness(witness), m_found(found), m_rows(database, found)
    {
    }

    void take(const LedgerLink& link)
    {
        if (m_found.chains.empty() || m_found.chains.back().name != link.chain)
            beginChain(link.chain);
        for (const QString& problem : problemsOf(link, m_end))
            differs(link, problem);
        checkWitness(link);
        m_end = {link.number, link.hash, link.signature};
        LedgerChain& chain = m_found.chains.back();
        chain.links = link.number;
        chain.hasSignatures = chain.hasSignatures && !link.signer.isEmpty();
        takeLeaves(link);
    }

    void finish(bool allRead)
    {
        if (allRead)
            m_rows.finish();
        m_found.witness = m_witness.chains.empty() ? WitnessState::Absent : WitnessState::Matched;
        for (const auto& [name, known] : m_witness.chains)
            checkEnd(name, known.links, allRead);
        for (const LedgerChain& chain : m_found.chains)
            if (!m_witness.chains.contains(chain.name) && m_found.witness == WitnessState::Matched)
                m_found.witness = WitnessState::Behind;
    }

private:
    void beginChain(const QString& name)
    {
        m_found.chains.push_back({name, 0, true, m_witness.chains.contains(name)});
        m_end = emptyLedgerHead();
    }

    void differs(const LedgerLink& link, const QString& what)
    {
        m_found.differs(u"ledger"_s, u"%1/%2"_s.arg(link.chain).arg(link.number), what);
    }

    void checkWitness(const LedgerLink& link)
    {
        const auto known = m_witness.chains.find(link.chain);
        if (known != m_witness.chains.end() && known->second.links == link.number &&
            known->second.hash != link.hash)
            differs(link, Words::tr("the second place knows another link of this number: the ledger was made "
                                    "anew, or an older copy was put back and gone on with"));
    }

    void checkEnd(const QString& name, qint64 knownLinks, bool allRead)
    {
        qint64 links = 0;
        for (const LedgerChain& chain : m_found.chains)
            if (chain.name == name)
                links = chain.links;
        if (links != knownLinks)
            m_found.witness = WitnessState::Behind;
        if (links < knownLinks && allRead)
            m_found.differs(
                u"ledger"_s, u"%1/%2"_s.arg(name).arg(links + 1),
                Words::tr("is missing, and what came after it: the second place knows %1 links. An "
                          "older copy was put back, or the end was cut off")
                    .arg(knownLinks));
    }

    void takeLeaves(const LedgerLink& link)
    {
        const auto leaves = unpackedLeaves(link.leaves);
        if (!leaves)
            return differs(link, Words::tr("its leaves cannot be read"));
        if (link.kind == LedgerKind::Found)
            m_found.foundRows += static_cast<qint64>(leaves->size());
        for (const LedgerLeaf& leaf : *leaves)
            m_rows.take(leaf);
    }

    const LibraryWitness& m_witness;
    LibraryVerification& m_found;
    RowCheck m_rows;
    LedgerHead m_end; ///< of the chain so far
};

} // namespace

QStringList problemsOf(const LedgerLink& link, const LedgerHead& before)
{
    QStringList problems;
    checkOrder(link, before, problems);
    checkContent(link, before, problems);
    return problems;
}

void checkLedger(Database& database, const LibraryWitness& witness, LibraryVerification& found)
{
    if (const auto others = ledger_table::ofOtherKinds(database); !others)
        found.differs(u"ledger"_s, {}, others.error().describe());
    else
        for (const QString& link : *others)
            found.differs(u"ledger"_s, link,
                          Words::tr("holds a value of another kind than the program writes"));
    LedgerCheck check(database, witness, found);
    const auto read = ledger_table::forEach(database, [&](const LedgerLink& link) { check.take(link); });
    if (!read)
        found.differs(u"ledger"_s, {}, read.error().describe());
    check.finish(read.has_value());
}

} // namespace gripscope
