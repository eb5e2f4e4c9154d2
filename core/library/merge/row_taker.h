// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/library/ledger/ledger_leaf.h"
#include "core/library/ledger/ledgered_tables.h"
#include "core/library/ledger/merged_rows.h"

#include <QString>

#include <map>
#include <optional>
#include <set>
#include <span>
#include <vector>

namespace gripscope {

class Database;

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

/// What versions and recipes are numbered in one library.
struct LibraryView {
    std::map<qint64, QString> changes;                     ///< keys of library_changes by version
    std::set<qint64> meetings;                             ///< versions of which rows only follow from others
    std::map<std::pair<QString, qint64>, QString> recipes; ///< keys of type_versions by type and number
    /// The change that a version names; the one before it where that was a meeting. Empty: none.
    [[nodiscard]] QString changeAt(qint64 version) const;
};

/// The views of the libraries that another one knows, itself among them, each read once.
class LibraryViews {
public:
    LibraryViews(Database& source, QString own) : m_source(source), m_own(std::move(own)) {}
    [[nodiscard]] Expected<const LibraryView*> of(const QString& library);

private:
    Database& m_source;
    QString m_own;
    std::map<QString, LibraryView> m_views;
};

/// A row in a link that is new here, as `library` has it.
struct NewLeaf {
    QString library;
    LedgerLeaf leaf;       ///< without a digest where no ledger comes with it
    bool madeThere = true; ///< not by a merge
};

/// What became of rows on their way into this library.
struct TakenRows {
    std::map<QString, qint64> byTable; ///< into the tables themselves
    qint64 forTheRecord = 0;           ///< beside them
    bool hasChanges = false;           ///< of types or squeezes of enrolments
    [[nodiscard]] qint64 sum() const;
};

/// Brings rows of another library in, a stretch of them at a time. Each is as it was but for what is numbered
/// in each library by itself; how it is there is kept beside it (MergedRow), so that the ledger it comes from
/// goes on to prove it. Within the write transaction of the caller.
class RowTaker {
public:
    RowTaker(Database& source, const QString& sourceId, Database& target);
    /// Rows of a library whose ledger does not come with them: how they are there is not kept.
    void takeWithoutLedger() { m_hasLedger = false; }

    /// Gives the changes that are new here their versions, in the order that all stations compute alike.
    /// Before all else.
    [[nodiscard]] Expected<void> giveVersions(const std::vector<NewLeaf>& changes);
    /// StorageCorrupt: a row is not what the ledger of its library says.
    [[nodiscard]] Expected<void> take(const TakenTable& table, const std::vector<NewLeaf>& leaves);
    [[nodiscard]] const TakenRows& taken() const { return m_taken; }

private:
    using Columns = std::vector<Column>;
    /// A row on its way.
    struct Arrival {
        NewLeaf leaf;
        TableRows::Row there;
        std::optional<TableRows::Row> here = {}; ///< nothing: something here excludes it
    };
    [[nodiscard]] Expected<void> takeStretch(const TakenTable& table, std::span<const NewLeaf> leaves);
    [[nodiscard]] Expected<std::vector<Arrival>>
    arrivalsOf(const TakenTable& table, std::span<const NewLeaf> leaves, std::vector<MergedRow>& kept);
    [[nodiscard]] Expected<void> bringIn(const TakenTable& table, const Columns& columns,
                                         std::vector<Arrival>& arrivals);
    [[nodiscard]] Expected<TableRows::Row> rowThere(const LedgeredTable& table, const NewLeaf& leaf);
    /// It only follows from changes of other libraries.
    [[nodiscard]] Expected<bool> followsOnly(const TakenTable& table, const QString& library,
                                             const Columns& columns, const TableRows::Row& row);
    [[nodiscard]] Expected<void> adapt(const TakenTable& table, const QString& library,
                                       const Columns& columns, TableRows::Row& row);
    [[nodiscard]] Expected<void> adaptType(const TakenTable& table, const LibraryView& view,
                                           const Columns& columns, TableRows::Row& row);
    [[nodiscard]] Expected<void> adaptRank(const Columns& columns, TableRows::Row& row);
    [[nodiscard]] Expected<qint64> versionHere(const QString& change);
    /// `sql`: SELECT 1 FROM ...
    [[nodiscard]] Expected<bool> isThere(const QString& sql, const std::vector<Cell>& values);
    [[nodiscard]] Expected<qint64> number(const QString& sql, const std::vector<Cell>& values = {});
    /// One more than the highest of a column.
    [[nodiscard]] Expected<qint64> next(const QString& table, const QString& column);

    Database& m_source;
    Database& m_target;
    RowViews m_there;
    LibraryViews m_views;
    std::map<QString, qint64> m_versions; ///< of changes here, by key; as far as they were asked for
    std::map<QString, qint64> m_next;
    std::set<QString> m_newSqueezes;
    std::map<QString, std::set<qint64>> m_ranks; ///< by squeeze, of its estimates
    TakenRows m_taken;
    bool m_hasLedger = true;
};

} // namespace gripscope
