// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QtEndian>

namespace gripscope {

/// qUncompress() of at most `most` bytes; empty where there would be more. It trusts the size in the first
/// four bytes and reserves that much memory, and the bytes may be anybody's.
[[nodiscard]] inline QByteArray inflated(const QByteArray& deflated, qint64 most)
{
    const bool bounded =
        deflated.size() >= 4 && qint64(qFromBigEndian<quint32>(deflated.constData())) <= most;
    return bounded ? qUncompress(deflated) : QByteArray();
}

} // namespace gripscope
