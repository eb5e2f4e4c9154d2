// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/library/ledger/ledger_leaf.h"
#include "core/library/ledger/merged_rows.h"
#include "core/library/merge/library_views.h"
#include "core/library/merge/taken_tables.h"

namespace gripscope {

/// A row in a link that is new here, as `library` has it.
struct NewLeaf {
    QString library;
    LedgerLeaf leaf;
    bool madeThere = true; ///< not by a merge
};

/// What became of rows on their way into this library.
struct TakenRows {
    std::map<QString, qint64> byTable; ///< into the tables themselves
    qint64 forTheRecord = 0;           ///< beside them
    bool hasChanges = false;           ///< of types or squeezes of enrolments
    [[nodiscard]] qint64 sum() const;
};

/// Brings rows of another library in. Each is as it was but for what is numbered in each library by itself;
/// how it is there is kept beside it (MergedRow), so that the ledger it comes from goes on to prove it.
/// Within the write transaction of the caller.
class RowTaker {
public:
    RowTaker(Database& source, const QString& sourceId, Database& target, const QString& targetId);

    /// Gives the changes that are new here their versions, in the order that all stations compute alike.
    /// Before all else.
    [[nodiscard]] Expected<void> giveVersions(const std::vector<NewLeaf>& changes);
    /// StorageCorrupt: a row is not what the ledger of its library says.
    [[nodiscard]] Expected<void> take(const TakenTable& table, const std::vector<NewLeaf>& leaves);
    [[nodiscard]] const TakenRows& taken() const { return m_taken; }

private:
    using Columns = std::vector<Column>;
    [[nodiscard]] Expected<void> takeOne(const TakenTable& table, const NewLeaf& leaf);
    [[nodiscard]] Expected<TableRows::Row> rowThere(const LedgeredTable& table, const NewLeaf& leaf);
    [[nodiscard]] Expected<void> adapt(const TakenTable& table, const QString& library,
                                       const Columns& columns, TableRows::Row& row);
    [[nodiscard]] Expected<void> insert(const TakenTable& table, const Columns& columns,
                                        const TableRows::Row& row);
    [[nodiscard]] Expected<void> keep(const TakenTable& table, const NewLeaf& leaf, const Columns& columns,
                                      const TableRows::Row& there, const TableRows::Row& here);
    [[nodiscard]] Expected<void> keepForTheRecord(const TakenTable& table, const NewLeaf& leaf,
                                                  const Columns& columns, const TableRows::Row& there);
    /// `sql`: SELECT 1 FROM ...
    [[nodiscard]] Expected<bool> isThere(const QString& sql, const std::vector<Cell>& values);
    [[nodiscard]] Expected<qint64> number(const QString& sql, const std::vector<Cell>& values = {});
    /// One more than the highest of a column.
    [[nodiscard]] Expected<qint64> next(const QString& table, const QString& column);

    Database& m_source;
    Database& m_target;
    RowViews m_there, m_here;
    LibraryViews m_views;
    std::map<QString, qint64> m_versions; ///< of changes here, by key
    std::map<QString, qint64> m_next;
    TakenRows m_taken;
};

} // namespace gripscope
