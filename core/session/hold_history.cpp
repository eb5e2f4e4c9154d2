// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/hold_history.h"

#include <algorithm>
#include <array>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

/// The entry of a gripper and a declaration; the end where there is none.
template <typename Entries>
auto find(Entries& entries, const QString& serial, const HoldEvidence& declaration)
{
    return std::find_if(entries.begin(), entries.end(), [&](const auto& entry) {
        return entry.serial == serial && entry.sum.declaresAs(declaration);
    });
}

QString serialOf(const Recording& recording)
{
    return recording.provenance.value(u"serial"_s);
}

} // namespace

HoldEvidence HoldHistory::before(const Recording& recording, const IdentificationOptions& options) const
{
    const auto entry = find(m_entries, serialOf(recording), holdDeclaration(recording, options));
    return entry == m_entries.end() ? HoldEvidence() : entry->sum;
}

void HoldHistory::add(const Recording& recording, const Identification& identification)
{
    const HoldEvidence& one = identification.holdEvidence;
    if (!one.gain || identification.validity.verdict == ValidityVerdict::Invalid)
        return;
    const QString serial = serialOf(recording);
    const auto entry = find(m_entries, serial, one);
    if (entry == m_entries.end())
        m_entries.push_back({serial, one});
    else
        entry->sum = combine(std::array{entry->sum, one});
}

} // namespace gripscope
