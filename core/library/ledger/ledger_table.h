// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/library/ledger/ledger_link.h"

#include <functional>

namespace gripscope {
class Database;
}

namespace gripscope::ledger_table {

[[nodiscard]] Expected<void> insert(Database& database, const LedgerLink& link);
[[nodiscard]] Expected<LedgerHead> head(Database& database, const QString& chain);
/// The hash of a link as stored; empty when there is none.
[[nodiscard]] Expected<QByteArray> hashOf(Database& database, const QString& chain, qint64 number);
/// Chain by chain, each from its first link. A link that cannot be read ends it with an error.
[[nodiscard]] Expected<void> forEach(Database& database, const std::function<void(const LedgerLink&)>& take);

} // namespace gripscope::ledger_table
