// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/library/ledger/ledgered_tables.h"

#include <span>

namespace gripscope {

/// How rows of a table come from another library.
struct TakenTable {
    enum class Kind {
        Taken,       ///< into the table itself
        ForTheRecord ///< beside it (MergedRow::whole): it is of its station alone
    };
    QString name;
    Kind kind = Kind::Taken;
    QString version = {}; ///< the column that names a version of the library; empty: none
    QString number = {};  ///< the column that is numbered in each library by itself; empty: none
    [[nodiscard]] const LedgeredTable& ledgered() const { return *ledgeredTable(name); }
};

/// All tables of the ledger, each behind those that it points to.
[[nodiscard]] std::span<const TakenTable> takenTables();

} // namespace gripscope
