// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/ledger/ledger_link.h"

#include "core/base/byte_writer.h"
#include "core/library/ledger/row_digest.h"

namespace gripscope {

using namespace Qt::StringLiterals;

QString toString(LedgerKind kind)
{
    switch (kind) {
    case LedgerKind::Written:
        return u"written"_s;
    case LedgerKind::Found:
        return u"found"_s;
    case LedgerKind::Unknown:
        break;
    }
    return {};
}

LedgerKind ledgerKindFrom(const QString& text)
{
    for (const LedgerKind kind : {LedgerKind::Written, LedgerKind::Found})
        if (toString(kind) == text)
            return kind;
    return LedgerKind::Unknown;
}

LedgerHead emptyLedgerHead()
{
    return {0, QByteArray(digestSize, '\0'), {}};
}

QByteArray linkHash(const LedgerLink& link, const QByteArray& previousSignature)
{
    ByteWriter out;
    out.text(u"gripscope ledger"_s).number(static_cast<qint32>(link.format));
    out.text(link.chain).number(link.number).text(toString(link.kind)).text(link.utc);
    out.counted(link.previousHash).counted(previousSignature);
    out.counted(link.signer).counted(link.leaves);
    return digestOf(out.bytes());
}

QString ledgerChain(const QString& station, const QByteArray& publicKey)
{
    constexpr qsizetype digits = 16;
    if (publicKey.isEmpty())
        return station;
    return station + u'/' + QString::fromLatin1(publicKey.toHex().left(digits));
}

} // namespace gripscope
