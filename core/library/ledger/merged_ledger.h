// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/library/ledger/ledger_link.h"
#include "core/library/ledger/library_witness.h"

#include <functional>
#include <map>
#include <utility>

namespace gripscope {

class Database;

/// By what a library is told from any other, and its copies are not: the first half of the hash of the first
/// link of its ledger. Empty before its first row.
[[nodiscard]] Expected<QString> libraryId(Database& database);

/// The ledgers of libraries that were merged into this one, link by link as they are there.
namespace merged_ledger {

using LibraryChain = std::pair<QString, QString>; ///< library, chain

/// StorageFailed: one of them is there already.
[[nodiscard]] Expected<void> insert(Database& database, const QString& library,
                                    const std::vector<LedgerLink>& links);
/// Where each chain ends.
[[nodiscard]] Expected<std::map<LibraryChain, ChainEnd>> ends(Database& database);
/// Where one of them ends; no links where it is not there.
[[nodiscard]] Expected<ChainEnd> endOf(Database& database, const LibraryChain& chain);
/// The hash of a link as stored; empty when there is none.
[[nodiscard]] Expected<QByteArray> hashOf(Database& database, const LibraryChain& chain, qint64 number);
/// The links of one chain behind `after`, up to `last`, in order.
[[nodiscard]] Expected<void> since(Database& database, const LibraryChain& chain, qint64 after, qint64 last,
                                   const std::function<void(const LedgerLink&)>& take);
/// How many links hold a value of another kind than the program writes.
[[nodiscard]] Expected<qint64> ofOtherKinds(Database& database);

} // namespace merged_ledger
} // namespace gripscope
