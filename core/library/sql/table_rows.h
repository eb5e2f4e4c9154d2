// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <QByteArray>
#include <QString>

#include <functional>
#include <memory>
#include <optional>
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
    [[nodiscard]] Expected<std::optional<Row>> withRowNumber(qint64 rowNumber);
    /// Until `take` says false.
    [[nodiscard]] Expected<void> forEachKey(const std::function<bool(const Cell&)>& take);

private:
    struct Private;
    explicit TableRows(std::unique_ptr<Private> d);
    std::unique_ptr<Private> d;
};

} // namespace gripscope
