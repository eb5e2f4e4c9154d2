// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/verification/row_check.h"

#include "core/base/words.h"
#include "core/library/ledger/ledger_table.h"
#include "core/library/ledger/row_digest.h"
#include "core/library/sql/database.h"
#include "core/library/verification/library_verification.h"

#include <QSet>
#include <QtEndian>

namespace gripscope {

namespace {

/// Of a row's key: enough that no two are alike by chance.
QByteArray keyDigest(const Cell& key)
{
    const bool isNumber = std::holds_alternative<qint64>(key);
    return digestOf((isNumber ? 'i' : 't') + keyText(key).toUtf8()).first(16);
}

} // namespace

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
        return m_found.differs(u"ledger"_qs, keyText(leaf.key),
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

} // namespace gripscope
