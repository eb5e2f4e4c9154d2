// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/words.h"
#include "core/library/ledger/ledger_leaf.h"
#include "core/library/ledger/merged_ledger.h"
#include "core/library/ledger/merged_rows.h"
#include "core/library/ledger/row_digest.h"
#include "core/library/sql/statement.h"
#include "core/library/verification/library_checks.h"
#include "core/library/verification/library_verification.h"
#include "core/people/audit_chain.h"

#include <QJsonDocument>
#include <QJsonObject>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

class MergedCheck {
public:
    MergedCheck(Database& database, const QString& own, LibraryVerification& found)
        : m_database(database), m_views(database, own), m_found(found)
    {
    }

    void checkChain(const merged_ledger::LibraryChain& chain, qint64 last)
    {
        LedgerHead end = emptyLedgerHead();
        MergedChain told{chain.first, chain.second, 0, true};
        const auto read = merged_ledger::since(m_database, chain, 0, last, [&](const LedgerLink& link) {
            for (const QString& problem : problemsOf(link, end))
                m_found.differs(u"merged_ledger"_s, u"%1/%2"_s.arg(link.chain).arg(link.number), problem);
            end = {link.number, link.hash, link.signature};
            told.hasSignatures = told.hasSignatures && !link.signer.isEmpty();
            const auto leaves = unpackedLeaves(link.leaves).value_or(std::vector<LedgerLeaf>());
            const bool madeThere = !isOfMerge(leaves);
            for (const LedgerLeaf& leaf : leaves)
                checkRow(chain.first, leaf, madeThere);
        });
        if (!read)
            m_found.differs(u"merged_ledger"_s, chain.second, read.error().describe());
        told.links = end.links;
        m_found.merged.push_back(told);
    }

    /// What stands beside the rows is all of some ledger.
    void finish()
    {
        const auto kept = merged_rows::count(m_database);
        if (!kept)
            m_found.differs(u"merged_rows"_s, {}, kept.error().describe());
        else if (*kept != m_used)
            m_found.differs(u"merged_rows"_s, {},
                            Words::tr("holds %1 rows, of which the ledgers of other stations know %2")
                                .arg(*kept)
                                .arg(m_used));
    }

private:
    void checkRow(const QString& library, const LedgerLeaf& leaf, bool madeThere)
    {
        const LedgeredTable* table = ledgeredTable(leaf.table);
        const QString key = keyText(leaf.key);
        if (table == nullptr)
            return m_found.differs(u"merged_ledger"_s, key,
                                   Words::tr("is of a table that this program does not know"));
        const auto columns = m_views.columns(*table);
        const auto view = m_views.rowIn(library, *table, leaf.key);
        if (!columns || !view)
            return m_found.differs(table->name, key, (columns ? view.error() : columns.error()).describe());
        ++m_found.mergedRows;
        if (!*view)
            return m_found.differs(table->name, key, Words::tr("of another station is missing"));
        if (rowDigest(**columns, (*view)->row) != leaf.digest)
            m_found.differs(table->name, key, Words::tr("is not as the other station wrote it"));
        if (const auto& merged = (*view)->merged) {
            ++m_used;
            checkNumber(*table, *merged, numberIn(**columns, (*view)->row, *table), madeThere);
        }
    }

    /// What is numbered in each library by itself, by that number; 0 of other tables.
    static qint64 numberIn(const std::vector<Column>& columns, const TableRows::Row& row,
                           const LedgeredTable& table)
    {
        if (table.name != u"inspections" && table.name != u"library_changes" &&
            table.name != u"type_versions")
            return 0;
        return integerIn(columns, row, table.name == u"inspections" ? u"number" : u"version");
    }

    void checkNumber(const LedgeredTable& table, const MergedRow& merged, qint64 number, bool madeThere)
    {
        const bool isOrigin = madeThere && number > 0 && !merged.whole;
        if (merged.number != number || merged.isOrigin != isOrigin)
            m_found.differs(u"merged_rows"_s, u"%1 %2"_s.arg(table.name, merged.key),
                            Words::tr("does not say where the row was made, or under which number"));
    }

    Database& m_database;
    RowViews m_views;
    LibraryVerification& m_found;
    qint64 m_used = 0;
};

/// The ends that were known at each merge, which is in the ledger of this library.
void checkHeads(Database& database, LibraryVerification& found)
{
    Statement query(database, Words::tr("be verified"), u"SELECT id, heads FROM library_meetings"_s);
    const auto done = query.forEach([&](Statement& row) {
        const QString id = row.takeText();
        const QJsonObject heads = QJsonDocument::fromJson(row.takeText().toUtf8()).object();
        for (auto head = heads.begin(); head != heads.end(); ++head) {
            const auto space = head.key().indexOf(u' ');
            const QStringList end = head.value().toString().split(u' ');
            const auto hash = merged_ledger::hashOf(
                database, {head.key().left(space), head.key().mid(space + 1)}, end.value(0).toLongLong());
            if (!hash || QString::fromLatin1(hash->toHex()) != end.value(1))
                found.differs(u"merged_ledger"_s, u"%1/%2"_s.arg(head.key().mid(space + 1), end.value(0)),
                              Words::tr("is missing or another than when it was merged"));
        }
    });
    if (!done)
        found.differs(u"library_meetings"_s, {}, done.error().describe());
}

AuditEntry auditEntryIn(const std::vector<Column>& columns, const TableRows::Row& row)
{
    const auto text = [&](QStringView column) { return textIn(columns, row, column); };
    AuditEntry entry;
    entry.number = integerIn(columns, row, u"number");
    entry.utc = text(u"created_utc");
    entry.station = text(u"station");
    entry.person = text(u"person");
    entry.role = text(u"role");
    entry.action = text(u"action");
    entry.subject = text(u"subject");
    entry.reason = text(u"reason");
    entry.details = text(u"details");
    entry.previousHash = text(u"previous_hash");
    entry.hash = text(u"hash");
    return entry;
}

/// The audit trails of other stations, each a chain of its own.
Expected<void> checkTrails(Database& database, LibraryVerification& found)
{
    ASSIGN_OR_RETURN(const auto columns, columnsOf(database, u"audit_entries"_s));
    std::map<QString, std::map<qint64, AuditEntry>> trails;
    Statement query(database, Words::tr("be verified"),
                    u"SELECT library, content FROM merged_rows WHERE table_code = ?"_s);
    query.bind(int(ledgeredTable(u"audit_entries"_s)->code));
    RETURN_IF_ERROR(query.forEach([&](Statement& row) {
        const QString library = row.takeText();
        TableRows::Row cells(columns->size());
        if (!merged_rows::apply(row.takeText(), *columns, cells))
            return; // told as a row that is not as it was written
        const AuditEntry entry = auditEntryIn(*columns, cells);
        trails[library][entry.number] = entry;
    }));
    for (const auto& [library, entries] : trails) {
        AuditChainCheck check(std::nullopt);
        for (const auto& [number, entry] : entries)
            check.take(entry);
        if (const AuditVerification trail = check.finish(); !trail.whole())
            found.differs(u"merged_rows"_s, u"audit_entries %1"_s.arg(trail.at), faultInWords(trail));
    }
    return {};
}

} // namespace

void checkMerged(Database& database, LibraryVerification& found)
{
    const auto own = libraryId(database);
    const auto ends = merged_ledger::ends(database);
    if (!own || !ends)
        return found.differs(u"merged_ledger"_s, {}, (own ? ends.error() : own.error()).describe());
    for (const auto& others : {merged_ledger::ofOtherKinds(database), merged_rows::ofOtherKinds(database)})
        if (!others || *others > 0)
            found.differs(u"merged_rows"_s, {},
                          Words::tr("holds a value of another kind than the program writes"));
    MergedCheck check(database, *own, found);
    for (const auto& [chain, end] : *ends)
        check.checkChain(chain, end.links);
    check.finish();
    checkHeads(database, found);
    if (const auto read = checkTrails(database, found); !read)
        found.differs(u"merged_rows"_s, {}, read.error().describe());
}

} // namespace gripscope
