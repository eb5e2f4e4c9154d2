// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QString>

namespace gripscope {

enum class LedgerKind {
    Written, ///< the rows that a transaction put in
    Found,   ///< rows from before the ledger, as a newer program found them
    Unknown, ///< a word that no program writes
};
[[nodiscard]] QString toString(LedgerKind kind); ///< "written", "found"; empty for Unknown
[[nodiscard]] LedgerKind ledgerKindFrom(const QString& text);

/// Where a chain ends.
struct LedgerHead {
    qint64 links = 0; ///< as many; also the number of the last
    QByteArray hash;  ///< of the last; that of emptyLedgerHead() where there is none
    QByteArray signature;
    friend bool operator==(const LedgerHead&, const LedgerHead&) = default;
};
[[nodiscard]] LedgerHead emptyLedgerHead();

/// One transaction in the chain of the station that made it.
struct LedgerLink {
    static constexpr int newestFormat = 1;
    QString chain;     ///< ledgerChain()
    qint64 number = 0; ///< from 1 on, without a hole
    LedgerKind kind = LedgerKind::Written;
    int format = newestFormat;
    QString utc;
    QByteArray leaves; ///< packed()
    QByteArray previousHash;
    QByteArray hash;
    QByteArray signer;    ///< a public key (Ed25519); empty where the station had none
    QByteArray signature; ///< by it, of the hash
};

/// SHA-256 over all of the link but its own hash and signature, and over the signature of the one before, so
/// that none can be taken off unseen.
[[nodiscard]] QByteArray linkHash(const LedgerLink& link, const QByteArray& previousSignature);

/// The name of the chain that a key writes at a station: the station, and the key's first 16 digits. What
/// somebody else signs can so never go on with it.
[[nodiscard]] QString ledgerChain(const QString& station, const QByteArray& publicKey);

} // namespace gripscope
