// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/sql/row_cursor.h"

#include "core/base/words.h"
#include "core/library/sql/server_rows.h"

#include <QSqlDriver>
#include <QVariant>

#include <cmath>
#include <limits>
#include <sqlite3.h>

namespace gripscope {

namespace {

sqlite3* connectionOf(const Database& database)
{
    const QVariant handle = database.connection().driver()->handle();
    const bool known = handle.isValid() && qstrcmp(handle.typeName(), "sqlite3*") == 0;
    return known ? *static_cast<sqlite3* const*>(handle.data()) : nullptr;
}

} // namespace

void RowCursor::Finalize::operator()(sqlite3_stmt* statement) const
{
    sqlite3_finalize(statement);
}

RowCursor::RowCursor(Database& database, QString doing) : m_database(&database), m_doing(std::move(doing)) {}
RowCursor::~RowCursor() = default;
RowCursor::RowCursor(RowCursor&&) noexcept = default;
RowCursor& RowCursor::operator=(RowCursor&&) noexcept = default;

Expected<RowCursor> RowCursor::open(Database& database, const QString& doing, const QString& sql)
{
    RowCursor cursor(database, doing);
    if (database.isOnServer()) {
        cursor.m_server = std::make_unique<ServerRows>(database, doing, sql);
        return cursor;
    }
    sqlite3* const connection = connectionOf(database);
    if (connection == nullptr)
        return failure(ErrorCode::StorageFailed,
                       {doing, Words::tr("Qt's SQLite driver does not give its connection")});
    sqlite3_stmt* statement = nullptr;
    const QByteArray text = sql.toUtf8();
    const int code = sqlite3_prepare_v2(connection, text.constData(), int(text.size()), &statement, nullptr);
    cursor.m_statement.reset(statement);
    if (code != SQLITE_OK)
        return failure(ErrorCode::StorageFailed, {doing, QString::fromUtf8(sqlite3_errmsg(connection))});
    return cursor;
}

void RowCursor::restart(std::initializer_list<std::string_view> texts)
{
    if (m_server)
        return m_server->restart(texts);
    sqlite3_reset(m_statement.get());
    int place = 0;
    for (const std::string_view text : texts)
        sqlite3_bind_text(m_statement.get(), ++place, text.data(), int(text.size()), SQLITE_TRANSIENT);
}

bool RowCursor::next()
{
    if (m_error)
        return false;
    if (m_server) {
        const bool onRow = m_server->next();
        m_error = m_server->error();
        return onRow;
    }
    const int code = sqlite3_step(m_statement.get());
    if (code == SQLITE_ROW)
        return true;
    if (code != SQLITE_DONE)
        fail(code);
    sqlite3_reset(m_statement.get()); // another step would begin anew
    return false;
}

void RowCursor::fail(int code)
{
    const QString what = QString::fromUtf8(sqlite3_errmsg(sqlite3_db_handle(m_statement.get())));
    const int primary = code & 0xff;
    const bool spoiled = primary == SQLITE_CORRUPT || primary == SQLITE_NOTADB;
    m_error = spoiled ? Error{ErrorCode::StorageCorrupt, {m_database->file(), what}}
                      : Error{ErrorCode::StorageFailed, {m_doing, what}};
}

std::string_view RowCursor::text(int column) const
{
    if (m_server)
        return m_server->text(column);
    const unsigned char* const begin = sqlite3_column_text(m_statement.get(), column);
    if (begin == nullptr)
        return {};
    return {reinterpret_cast<const char*>(begin),
            std::size_t(sqlite3_column_bytes(m_statement.get(), column))};
}

qint64 RowCursor::integer(int column) const
{
    return m_server ? m_server->integer(column) : sqlite3_column_int64(m_statement.get(), column);
}

double RowCursor::real(int column) const
{
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    if (m_server)
        return m_server->real(column).value_or(none);
    const double number = sqlite3_column_double(m_statement.get(), column);
    if (number == 0 && sqlite3_column_type(m_statement.get(), column) == SQLITE_NULL)
        return none;
    return std::isfinite(number) ? number : none;
}

} // namespace gripscope
