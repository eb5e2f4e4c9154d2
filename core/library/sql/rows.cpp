// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/sql/rows.h"

#include "core/base/words.h"

#include <QSqlDriver>
#include <QSqlError>
#include <QSqlQuery>
#include <QSqlRecord>
#include <QVariant>

#include <atomic>
#include <cmath>
#include <limits>
#include <sqlite3.h>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

sqlite3* connectionOf(const Database& database)
{
    const QVariant handle = database.connection().driver()->handle();
    const bool known = handle.isValid() && qstrcmp(handle.typeName(), "sqlite3*") == 0;
    return known ? *static_cast<sqlite3* const*>(handle.data()) : nullptr;
}

constexpr int fewRows = 16;
constexpr int manyRows = 1024;

QString literal(std::string_view text)
{
    QString quoted = QString::fromUtf8(text.data(), qsizetype(text.size()));
    return u'\'' + quoted.replace(u'\'', u"''"_s) + u'\'';
}

} // namespace

/// What RowCursor reads from a server: by a cursor there, some at first and then a thousand at a time, so
/// that neither a look-up nor a million rows cost more than they have to. Within a transaction.
class RowCursor::ServerRows {
public:
    ServerRows(Database& database, QString doing, const QString& sql);
    ~ServerRows();
    ServerRows(const ServerRows&) = delete;
    ServerRows& operator=(const ServerRows&) = delete;

    void restart(std::initializer_list<std::string_view> texts);
    bool next();
    [[nodiscard]] const std::optional<Error>& error() const { return m_error; }
    [[nodiscard]] std::string_view text(int column) const;
    [[nodiscard]] qint64 integer(int column) const;
    [[nodiscard]] std::optional<double> real(int column) const;

private:
    bool fetch();
    void close();
    Database& m_database;
    QString m_doing, m_sql, m_name;
    QSqlQuery m_rows;
    mutable std::vector<QByteArray> m_texts; ///< of the row it stands on, as far as they were asked for
    int m_atOnce = 0, m_left = 0;
    bool m_declared = false;
    std::optional<Error> m_error;
};

RowCursor::ServerRows::ServerRows(Database& database, QString doing, const QString& sql)
    : m_database(database), m_doing(std::move(doing)), m_sql(database.dialect().spelled(sql)),
      m_rows(database.connection())
{
    static std::atomic<quint64> counter{0};
    m_name = u"gripscope_rows_%1"_s.arg(++counter);
}

RowCursor::ServerRows::~ServerRows()
{
    if (!m_error) // else the transaction is at its end
        close();
}

void RowCursor::ServerRows::close()
{
    if (std::exchange(m_declared, false))
        static_cast<void>(m_database.execute(u"CLOSE "_s + m_name, m_doing));
}

void RowCursor::ServerRows::restart(std::initializer_list<std::string_view> texts)
{
    if (m_error)
        return;
    close();
    QString sql = u"DECLARE %1 NO SCROLL CURSOR FOR "_s.arg(m_name);
    const QStringList parts = m_sql.split(u'?');
    auto text = texts.begin();
    for (qsizetype i = 0; i < parts.size(); ++i)
        sql += (i == 0 ? QString() : literal(text != texts.end() ? *text++ : std::string_view())) + parts[i];
    if (const auto declared = m_database.execute(sql, m_doing); !declared)
        m_error = declared.error();
    m_declared = !m_error;
    m_atOnce = fewRows;
    m_left = 0;
    m_rows.clear();
}

bool RowCursor::ServerRows::fetch()
{
    if (!m_rows.exec(u"FETCH %1 FROM %2"_s.arg(m_atOnce).arg(m_name))) {
        m_error = m_database.error(m_rows.lastError(), m_doing).value();
        return false;
    }
    m_left = m_atOnce;
    m_atOnce = manyRows;
    if (m_texts.empty()) // to ask for each row takes longer than to read it
        m_texts.resize(std::size_t(m_rows.record().count()));
    return true;
}

bool RowCursor::ServerRows::next()
{
    for (QByteArray& text : m_texts)
        text.clear();
    if (m_error || !m_declared)
        return false;
    if (m_left == 0 && !fetch())
        return false;
    --m_left;
    if (m_rows.next())
        return true;
    close(); // fewer came than were asked for: another step does not begin anew
    return false;
}

std::string_view RowCursor::ServerRows::text(int column) const
{
    QByteArray& text = m_texts[std::size_t(column)];
    if (text.isNull())
        text = m_rows.value(column).toString().toUtf8();
    return {text.constData(), std::size_t(text.size())};
}

qint64 RowCursor::ServerRows::integer(int column) const
{
    return m_rows.value(column).toLongLong();
}

std::optional<double> RowCursor::ServerRows::real(int column) const
{
    const QVariant value = m_rows.value(column);
    const double number = value.toDouble();
    return value.isNull() || !std::isfinite(number) ? std::nullopt : std::optional(number);
}

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
