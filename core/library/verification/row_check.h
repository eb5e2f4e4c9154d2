// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/library/ledger/ledger_leaf.h"
#include "core/library/ledger/ledgered_tables.h"

#include <map>

namespace gripscope {

class Database;
struct LibraryVerification;

/// Leaves against the rows that they are of, and then rows against the leaves.
class RowCheck {
public:
    RowCheck(Database& database, LibraryVerification& found);
    /// Every leaf of the ledger.
    void take(const LedgerLeaf& leaf);
    /// Whether each row has one leaf; after the last leaf.
    void finish();

private:
    /// A number for a set of keys, whatever their order: the sum of a digest of each, modulo 2^128. Two sets
    /// with the same number and the same size are the same.
    struct Tally {
        quint64 count = 0, high = 0, low = 0;
        void add(const Cell& key);
        friend bool operator==(const Tally&, const Tally&) = default;
    };
    struct Table {
        const LedgeredTable* known = nullptr;
        std::optional<TableRows> rows; ///< none where the table cannot be read
        Tally leaves;
    };
    Table& tableOf(quint8 code);
    void nameRowsWithout(const Table& table);

    Database& m_database;
    LibraryVerification& m_found;
    std::map<quint8, Table> m_tables;
};

} // namespace gripscope
