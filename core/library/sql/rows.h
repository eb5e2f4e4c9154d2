// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/library/sql/database.h"
#include "core/library/sql/statement.h"

#include <initializer_list>
#include <memory>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

struct sqlite3_stmt;

namespace gripscope {

/// All rows of a query, each taken by `take`; an error when one of them cannot be taken.
template <typename Record>
[[nodiscard]] Expected<std::vector<Record>> allRows(Statement& query, Expected<Record> (*take)(Statement&))
{
    std::vector<Record> records;
    std::optional<Error> error;
    auto done = query.forEach([&](Statement& row) {
        Expected<Record> record = take(row);
        if (record)
            records.push_back(std::move(*record));
        else
            error = record.error();
    });
    if (!done)
        return tl::unexpected<Error>(done.error());
    if (error)
        return tl::unexpected<Error>(*error);
    return records;
}

/// The same where any row can be taken.
template <typename Record>
[[nodiscard]] Expected<std::vector<Record>> allRows(Statement& query, Record (*take)(Statement&))
{
    std::vector<Record> records;
    auto done = query.forEach([&](Statement& row) { records.push_back(take(row)); });
    if (!done)
        return tl::unexpected<Error>(done.error());
    return records;
}

/// The first row of a query, of those that allRows() gives; nothing when there is none.
template <typename Taken>
[[nodiscard]] auto firstRow(Statement& query, Taken (*take)(Statement&))
{
    return allRows(query, take).map([](auto found) {
        return found.empty() ? std::nullopt : std::optional(std::move(found.front()));
    });
}

/// The whole number that the last row begins with; 0 where there is no row.
[[nodiscard]] inline Expected<qint64> numberOf(Statement& query)
{
    qint64 number = 0;
    return query.forEach([&](Statement& row) { number = row.takeInteger(); }).map([&] { return number; });
}

/// The rows of a SELECT one after another, straight from SQLite: for millions of them, of which each would
/// take a QVariant a column (Statement) longer than to be found. Texts are UTF-8, and those of the row that
/// it stands on; gone with the next step. On a server, by a cursor of its own (ServerRows), and within a
/// transaction.
class RowCursor {
public:
    /// `doing` completes "the library could not ...". StorageFailed.
    [[nodiscard]] static Expected<RowCursor> open(Database& database, const QString& doing,
                                                  const QString& sql);
    ~RowCursor();
    RowCursor(RowCursor&&) noexcept;
    RowCursor& operator=(RowCursor&&) noexcept;

    /// Before the first row again, with these texts in place of the question marks.
    void restart(std::initializer_list<std::string_view> texts);
    /// To the next row; false behind the last, and where reading failed, which error() tells.
    bool next();
    [[nodiscard]] const std::optional<Error>& error() const { return m_error; }

    /// So many steps take as long as to begin anew: on a server that is three ways there and back.
    [[nodiscard]] int stepsALookUp() const { return m_server ? 400 : 8; }

    [[nodiscard]] std::string_view text(int column) const;
    [[nodiscard]] qint64 integer(int column) const;
    [[nodiscard]] double real(int column) const; ///< NaN where there is none, or an infinity

private:
    class ServerRows;
    struct Finalize {
        void operator()(sqlite3_stmt* statement) const;
    };
    RowCursor(Database& database, QString doing);
    void fail(int code);

    Database* m_database;
    QString m_doing;
    std::unique_ptr<sqlite3_stmt, Finalize> m_statement;
    std::unique_ptr<ServerRows> m_server; ///< instead
    std::optional<Error> m_error;
};

} // namespace gripscope
