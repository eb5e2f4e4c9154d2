// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/squeeze/hold_history.h"

#include <QHash>

#include <algorithm>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

QString serialOf(const Recording& recording)
{
    return recording.provenance.value(u"serial"_s);
}

/// Of the samples: two squeezes with noise never agree in all of them.
std::size_t fingerprintOf(const Recording& recording)
{
    const std::size_t force = qHashBits(recording.force.data(), recording.force.size() * sizeof(double));
    return qHashBits(recording.position.data(), recording.position.size() * sizeof(double), force);
}

} // namespace

HoldEvidence HoldHistory::before(const Recording& recording, const IdentificationOptions& options) const
{
    const QString serial = serialOf(recording);
    const std::size_t fingerprint = fingerprintOf(recording);
    const HoldEvidence declaration = holdDeclaration(recording, options);
    std::vector<HoldEvidence> counted;
    for (const Entry& entry : m_entries)
        if (entry.serial == serial && entry.fingerprint != fingerprint &&
            entry.evidence.declaresAs(declaration))
            counted.push_back(entry.evidence);
    return combine(counted);
}

void HoldHistory::add(const Recording& recording, const Identification& identification)
{
    const HoldEvidence& one = identification.holdEvidence;
    if (!one.gain || identification.validity.verdict == ValidityVerdict::Invalid)
        return;
    const QString serial = serialOf(recording);
    const std::size_t fingerprint = fingerprintOf(recording);
    const bool known = std::any_of(m_entries.begin(), m_entries.end(), [&](const Entry& entry) {
        return entry.serial == serial && entry.fingerprint == fingerprint && entry.evidence.declaresAs(one);
    });
    if (!known)
        m_entries.push_back({serial, fingerprint, one});
}

} // namespace gripscope
