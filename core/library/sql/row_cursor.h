// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/library/sql/database.h"

#include <memory>
#include <optional>
#include <string_view>

struct sqlite3_stmt;

namespace gripscope {

class ServerRows;

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
