// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <QByteArray>
#include <QString>

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <variant>
#include <vector>

namespace gripscope {

class Database;

/// One value of a row as it is stored; monostate is NULL.
using Cell = std::variant<std::monostate, qint64, double, QString, QByteArray>;

struct Column {
    QString name;
    Cell fallback; ///< what a row has that is from before the column; NULL where the schema names nothing
};

/// The columns of a table by name, read once for a connection. Empty: there is no such table.
[[nodiscard]] Expected<const std::vector<Column>*> columnsOf(Database& database, const QString& table);

/// Rows of one table whatever their columns are, for what has to see every one of them: in the order of
/// columnsOf().
class TableRows {
public:
    using Row = std::vector<Cell>;

    /// `key`: a column that no two rows have the same value in.
    [[nodiscard]] static Expected<TableRows> of(Database& database, const QString& table, const QString& key);
    ~TableRows();
    TableRows(TableRows&&) noexcept;
    TableRows& operator=(TableRows&&) = delete;

    [[nodiscard]] const std::vector<Column>& columns() const;
    /// Nothing where there is none.
    [[nodiscard]] Expected<std::optional<Row>> withKey(const Cell& key);
    /// Many in few queries; those that are not there are left out.
    [[nodiscard]] Expected<std::map<Cell, Row>> withKeys(const std::vector<Cell>& keys);
    [[nodiscard]] Expected<std::map<qint64, Row>> withRowNumbers(const std::vector<qint64>& rowNumbers);
    /// Until `take` says false.
    [[nodiscard]] Expected<void> forEachKey(const std::function<bool(const Cell&)>& take);

    /// Puts rows in, many in one statement, and leaves out those that something there excludes. Returns the
    /// keys of those that were put in. Each has a cell for each of columns().
    [[nodiscard]] Expected<std::set<Cell>> insert(const std::vector<Row>& rows, const QString& doing);
    /// StorageFailed: something there excludes one of them.
    [[nodiscard]] Expected<void> insertAll(const std::vector<Row>& rows, const QString& doing);

private:
    struct Private;
    explicit TableRows(std::unique_ptr<Private> d);
    std::unique_ptr<Private> d;
};

} // namespace gripscope
