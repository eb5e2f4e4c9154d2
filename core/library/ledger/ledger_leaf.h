// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/library/sql/table_rows.h"

#include <optional>
#include <vector>

namespace gripscope {

/// One row in the ledger.
struct LedgerLeaf {
    quint8 table = 0; ///< LedgeredTable::code
    Cell key;         ///< text or an integer
    QByteArray digest;
    friend bool operator==(const LedgerLeaf&, const LedgerLeaf&) = default;
};

/// Leaf behind leaf: the table's code, the key, the digest. A key is 'u' and the 16 bytes of a UUID where its
/// text is one, 't' and a counted text, or 'i' and a 64-bit integer.
[[nodiscard]] QByteArray packed(const std::vector<LedgerLeaf>& leaves);
/// Nothing where the bytes are not such.
[[nodiscard]] std::optional<std::vector<LedgerLeaf>> unpackedLeaves(const QByteArray& bytes);

/// As it is read by a person: "0190…" or "12".
[[nodiscard]] QString keyText(const Cell& key);

} // namespace gripscope
