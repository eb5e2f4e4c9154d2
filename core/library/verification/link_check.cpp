// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/verification/link_check.h"

#include "core/base/words.h"
#include "core/library/ledger/station_key.h"

namespace gripscope {

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

} // namespace

QStringList problemsOf(const LedgerLink& link, const LedgerHead& before)
{
    QStringList problems;
    checkOrder(link, before, problems);
    checkContent(link, before, problems);
    return problems;
}

} // namespace gripscope
