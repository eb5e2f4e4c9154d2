// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/library/ledger/ledger_link.h"
#include "core/library/ledger/library_witness.h"

#include <QStringList>

#include <functional>

namespace gripscope {
class Database;
class Statement;
} // namespace gripscope

namespace gripscope::ledger_table {

[[nodiscard]] Expected<void> insert(Database& database, const LedgerLink& link);
[[nodiscard]] Expected<LedgerHead> head(Database& database, const QString& chain);
/// The link that was put in first, of whatever chain, which never changes; nothing where there is none yet.
[[nodiscard]] Expected<std::optional<ChainEnd>> birth(Database& database);
/// Of a row with chain, number, kind, format, created_utc, leaves, previous_hash, hash, signer, signature.
[[nodiscard]] LedgerLink takeLink(Statement& row);
/// Where each chain ends, by name.
[[nodiscard]] Expected<std::map<QString, ChainEnd>> ends(Database& database);
/// The links of one chain behind `after`, up to `last`, in order.
[[nodiscard]] Expected<void> since(Database& database, const QString& chain, qint64 after, qint64 last,
                                   const std::function<void(const LedgerLink&)>& take);
/// The hash of a link as stored; empty when there is none.
[[nodiscard]] Expected<QByteArray> hashOf(Database& database, const QString& chain, qint64 number);
/// The same for settleRestore(); empty also where the ledger cannot be read.
[[nodiscard]] LinkHash hashesOf(Database& database);
/// Links, as chain/number, with a value of another storage class than the program writes, such as bytes in
/// place of a text: they would be read as the same. (SQLite checks no CHECK of a file that is open to be read
/// only.)
[[nodiscard]] Expected<QStringList> ofOtherKinds(Database& database);
/// Chain by chain, each from its first link. A link that cannot be read ends it with an error.
[[nodiscard]] Expected<void> forEach(Database& database, const std::function<void(const LedgerLink&)>& take);

} // namespace gripscope::ledger_table
