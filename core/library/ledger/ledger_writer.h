// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/library/ledger/library_witness.h"

#include <optional>

namespace gripscope {

class Database;

/// The last thing in a write transaction, while it holds the lock: one link over the rows that it put in.
/// Returns where the chain then ends; nothing where no row was put in.
[[nodiscard]] Expected<std::optional<ChainEnd>> continueLedger(Database& database);

/// Once, in the migration that makes the ledger: all rows that are there enter as they are found.
[[nodiscard]] Expected<void> enterFoundRows(Database& database);

} // namespace gripscope
