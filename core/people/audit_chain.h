// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/people/audit_entry.h"

namespace gripscope {

/// How far a trail goes and how it ends: what is kept in a second place
/// (core/library/ledger/library_witness.h).
struct AuditHead {
    qint64 entries = 0;
    QString hash;
    friend bool operator==(const AuditHead&, const AuditHead&) = default;
};

enum class AuditFault {
    None,
    Missing,  ///< the numbers have a gap: entries were removed
    Unlinked, ///< it does not follow from the one before: entries were removed, put in or exchanged
    Changed,  ///< its text is not what was hashed
    CutShort, ///< the second place knows of more entries
    Replaced, ///< the second place knows another hash of that entry: the chain was made anew
};
[[nodiscard]] QString toString(AuditFault fault); ///< "missing", ...; empty for None

struct AuditVerification {
    AuditHead head; ///< of what is there
    AuditFault fault = AuditFault::None;
    qint64 at = 0;          ///< the first entry that is not in order
    bool witnessed = false; ///< the second place knows this library
    QString witness;        ///< the file that is the second place
    [[nodiscard]] bool whole() const { return fault == AuditFault::None; }
};
/// The fault alone, a sentence; empty where there is none.
[[nodiscard]] QString faultInWords(const AuditVerification& verification);
/// What was found, what it means, what to do next.
[[nodiscard]] QString inWords(const AuditVerification& verification);

/// Goes along a trail, entry by entry from the first; the first fault stays.
class AuditChainCheck {
public:
    /// `witness`: what the second place knows; none when nothing.
    explicit AuditChainCheck(std::optional<AuditHead> witness) : m_witness(std::move(witness)) {}
    void take(const AuditEntry& entry);
    [[nodiscard]] AuditVerification finish() const;

private:
    void fail(AuditFault fault, qint64 at);
    std::optional<AuditHead> m_witness;
    AuditVerification m_found;
};

} // namespace gripscope
