// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <span>

namespace gripscope {

/// A table whose rows enter the ledger: all do but the ledger's own. The code stands in every leaf, and is
/// never given to another table.
struct LedgeredTable {
    quint8 code = 0;
    QString name;
    QString key; ///< the column that names a row
};

[[nodiscard]] std::span<const LedgeredTable> ledgeredTables();
[[nodiscard]] const LedgeredTable* ledgeredTable(const QString& name); ///< nullptr: none
[[nodiscard]] const LedgeredTable* ledgeredTable(quint8 code);         ///< nullptr: none

} // namespace gripscope
