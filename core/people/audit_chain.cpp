// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/people/audit_chain.h"

#include "core/base/words.h"

namespace gripscope {

using namespace Qt::StringLiterals;

QString faultInWords(const AuditVerification& found)
{
    switch (found.fault) {
    case AuditFault::None:
        return {};
    case AuditFault::Missing:
        return Words::tr("Before entry %1 at least one entry was removed.").arg(found.at);
    case AuditFault::Unlinked:
        return Words::tr("Entry %1 does not follow from the one before it: an entry was removed, put in or "
                         "exchanged.")
            .arg(found.at);
    case AuditFault::Changed:
        return Words::tr("Entry %1 was changed after it was written.").arg(found.at);
    case AuditFault::CutShort:
        return Words::tr(
                   "From entry %1 on entries are missing at the end: this computer has seen more of them.")
            .arg(found.at);
    case AuditFault::Replaced:
        return Words::tr(
                   "Entry %1 is not the one that this computer has seen: the trail was written anew, or "
                   "another "
                   "library was put in its place.")
            .arg(found.at);
    }
    return {};
}

QString toString(AuditFault fault)
{
    switch (fault) {
    case AuditFault::None:
        return {};
    case AuditFault::Missing:
        return u"missing"_s;
    case AuditFault::Unlinked:
        return u"unlinked"_s;
    case AuditFault::Changed:
        return u"changed"_s;
    case AuditFault::CutShort:
        return u"cut_short"_s;
    case AuditFault::Replaced:
        return u"replaced"_s;
    }
    return {};
}

QString inWords(const AuditVerification& found)
{
    if (!found.whole())
        return Words::tr(
                   "The audit trail is not in order. %1 Keep the library as it is, compare it with a copy, "
                   "and "
                   "tell whoever answers for quality.")
            .arg(faultInWords(found));
    if (found.head.entries == 0)
        return Words::tr("The audit trail is empty.");
    const QString whole = Words::tr("All %1 entries are as they were written, in order and without a gap.")
                              .arg(found.head.entries);
    return found.witnessed
               ? Words::tr("%1 The end agrees with what this computer has seen.").arg(whole)
               : Words::tr("%1 This computer has not seen this library before: whether entries are "
                           "missing at the end "
                           "cannot be told here.")
                     .arg(whole);
}

void AuditChainCheck::fail(AuditFault fault, qint64 at)
{
    if (m_found.fault != AuditFault::None)
        return;
    m_found.fault = fault;
    m_found.at = at;
}

void AuditChainCheck::take(const AuditEntry& entry)
{
    AuditHead& head = m_found.head;
    if (entry.number != head.entries + 1)
        fail(AuditFault::Missing, entry.number);
    if (entry.hash != auditHash(entry))
        fail(AuditFault::Changed, entry.number);
    if (entry.previousHash != (head.entries == 0 ? firstPreviousHash() : head.hash))
        fail(AuditFault::Unlinked, entry.number);
    if (m_witness && entry.number == m_witness->entries && entry.hash != m_witness->hash)
        fail(AuditFault::Replaced, entry.number);
    head = {entry.number, entry.hash};
}

AuditVerification AuditChainCheck::finish() const
{
    AuditChainCheck ended = *this;
    if (m_witness && m_witness->entries > m_found.head.entries)
        ended.fail(AuditFault::CutShort, m_found.head.entries + 1);
    ended.m_found.witnessed = m_witness.has_value();
    return ended.m_found;
}

} // namespace gripscope
