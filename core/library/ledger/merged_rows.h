// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/library/ledger/ledger_leaf.h"
#include "core/library/ledger/ledgered_tables.h"
#include "core/library/sql/table_rows.h"

#include <map>

namespace gripscope {

/// How a row is in a library that was merged into this one: what of it differs from the row here, or all of
/// it where it is kept for the record alone.
struct MergedRow {
    QString library;       ///< libraryId()
    quint8 table = 0;      ///< LedgeredTable::code
    QString key;           ///< keyText()
    qint64 number = 0;     ///< an inspection's, a version's or a recipe's there
    bool isOrigin = false; ///< it was made there
    bool whole = false;
    QString content; ///< a JSON object: each column's value, a letter for its kind before it
};

/// Whether a link is of a merge: its rows were made elsewhere, or follow from others.
[[nodiscard]] bool isOfMerge(const std::vector<LedgerLeaf>& link);

namespace merged_rows {

/// StorageFailed: one of them is there already.
[[nodiscard]] Expected<void> insert(Database& database, const std::vector<MergedRow>& rows);
[[nodiscard]] Expected<std::optional<MergedRow>> find(Database& database, const QString& library,
                                                      quint8 table, const QString& key);
/// By key the numbers of the rows of a table as one library has them.
[[nodiscard]] Expected<std::map<QString, qint64>> numbers(Database& database, const QString& library,
                                                          quint8 table, bool whole);
[[nodiscard]] Expected<qint64> count(Database& database);
/// How many hold a value of another kind than the program writes.
[[nodiscard]] Expected<qint64> ofOtherKinds(Database& database);

/// All of a row, as content.
[[nodiscard]] QString contentOf(const std::vector<Column>& columns, const TableRows::Row& row);
/// What of `there` differs from `here`; empty where nothing does.
[[nodiscard]] QString difference(const std::vector<Column>& columns, const TableRows::Row& there,
                                 const TableRows::Row& here);
/// Puts content into a row. False where it is none.
[[nodiscard]] bool apply(const QString& content, const std::vector<Column>& columns, TableRows::Row& row);

} // namespace merged_rows

/// Rows as a library has them: the one that is open, or one that was merged into it.
class RowViews {
public:
    /// `own`: libraryId() of the database.
    RowViews(Database& database, QString own) : m_database(database), m_own(std::move(own)) {}

    struct View {
        TableRows::Row row;
        std::optional<MergedRow> merged; ///< what made it differ from the row here
    };
    [[nodiscard]] Expected<std::optional<View>> rowIn(const QString& library, const LedgeredTable& table,
                                                      const Cell& key);
    /// The row of the open one.
    [[nodiscard]] Expected<std::optional<TableRows::Row>> own(const LedgeredTable& table, const Cell& key);
    [[nodiscard]] Expected<const std::vector<Column>*> columns(const LedgeredTable& table);

private:
    [[nodiscard]] Expected<TableRows*> rowsOf(const LedgeredTable& table);
    Database& m_database;
    QString m_own;
    std::map<quint8, TableRows> m_tables;
};

/// The value of a column; NULL where there is none of that name.
[[nodiscard]] Cell cellIn(const std::vector<Column>& columns, const TableRows::Row& row, QStringView column);
/// The same of a column of whole numbers, or of texts; 0 and an empty one for any other value.
[[nodiscard]] qint64 integerIn(const std::vector<Column>& columns, const TableRows::Row& row,
                               QStringView column);
[[nodiscard]] QString textIn(const std::vector<Column>& columns, const TableRows::Row& row,
                             QStringView column);
/// With these values, and NULL in the columns that are not named.
[[nodiscard]] TableRows::Row rowWith(const std::vector<Column>& columns,
                                     std::initializer_list<std::pair<QStringView, Cell>> values);
/// Nothing happens where there is no such column.
void setCell(const std::vector<Column>& columns, TableRows::Row& row, QStringView column, const Cell& value);

} // namespace gripscope
