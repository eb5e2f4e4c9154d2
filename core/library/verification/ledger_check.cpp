// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/verification/ledger_check.h"

#include "core/base/words.h"
#include "core/library/ledger/ledger_table.h"
#include "core/library/ledger/library_witness.h"
#include "core/library/sql/database.h"
#include "core/library/verification/library_verification.h"
#include "core/library/verification/link_check.h"
#include "core/library/verification/row_check.h"

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

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
