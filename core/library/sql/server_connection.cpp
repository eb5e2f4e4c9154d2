// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/words.h"
#include "core/library/sql/database.h"
#include "core/library/sql/hangup.h"
#include "core/library/sql/server_words.h"
#include "core/library/sql/unique_connection.h"

#include <QSqlDriver>
#include <QSqlError>
#include <QSqlQuery>

#include <libpq-fe.h>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

/// In libpq's form; Qt takes a semicolon for a blank.
QString quotedOption(const QString& name, QString value)
{
    value.replace(u'\\', u"\\\\"_s).replace(u'\'', u"\\'"_s);
    return u"%1='%2'"_s.arg(name, value);
}

/// A network that is gone is noticed after a minute at most, whether this computer waits for an answer or has
/// something to send.
QString optionsOf(const ServerAddress& server)
{
    std::map<QString, QString> options{
        {u"connect_timeout"_s, u"10"_s},        {u"keepalives"_s, u"1"_s},
        {u"keepalives_idle"_s, u"20"_s},        {u"keepalives_interval"_s, u"10"_s},
        {u"keepalives_count"_s, u"4"_s},        {u"tcp_user_timeout"_s, u"60000"_s},
        {u"application_name"_s, u"gripscope"_s}};
    for (const auto& [name, value] : server.options)
        options[name] = value;
    QStringList spelled;
    for (const auto& [name, value] : options)
        spelled << quotedOption(name, value);
    return spelled.join(u';');
}

/// What the server has to be to hold a library.
std::optional<QString> notFit(const QSqlDatabase& connection)
{
    constexpr int oldestVersion = 130'000;
    QSqlQuery query(connection);
    if (!query.exec(u"SELECT current_setting('server_encoding'), current_setting('server_version_num')::int, "
                    "COALESCE(current_schema()::text, '')"_s) ||
        !query.next())
        return query.lastError().databaseText().simplified();
    if (query.value(0).toString() != "UTF8"_L1)
        return Words::tr("its database has the encoding %1, which does not hold every sign; make it with "
                         "createdb --encoding=UTF8 --template=template0")
            .arg(query.value(0).toString());
    if (query.value(1).toInt() < oldestVersion)
        return Words::tr("the server is PostgreSQL %1; it has to be 13 or newer")
            .arg(query.value(1).toInt() / 10'000);
    if (query.value(2).toString().isEmpty())
        return Words::tr("the user has no schema to work in; let who looks after the server grant the rights "
                         "to the schema public");
    return {};
}

/// By which libpq talks to the server; -1: none.
int socketOf(const QSqlDatabase& connection)
{
    const QVariant handle = connection.driver()->handle();
    return qstrcmp(handle.typeName(), "pg_conn*") == 0 // a PGconn*
               ? PQsocket(*static_cast<PGconn* const*>(handle.constData()))
               : -1;
}

} // namespace

Expected<std::unique_ptr<Database>> Database::connectToServer(const LibraryLocation& location, bool toRead,
                                                              const std::shared_ptr<Hangup>& hangup)
{
    const SqlDialect& dialect = SqlDialect::postgresql();
    if (!QSqlDatabase::isDriverAvailable(dialect.driver()))
        return failure(ErrorCode::StorageOpen, {location.text(), dialect.driverMissing()});
    std::unique_ptr<Database> database(new Database(location.text(), dialect, uniqueConnectionName()));
    const ServerAddress& server = *location.server();
    database->m_server = server;
    database->m_toRead = toRead;
    database->m_hangup = hangup;
    database->m_connection.setHostName(server.host);
    database->m_connection.setPort(server.port);
    database->m_connection.setDatabaseName(server.database);
    database->m_connection.setUserName(server.user);
    database->m_connection.setConnectOptions(optionsOf(server));
    RETURN_IF_ERROR(database->openConnection());
    return database;
}

Expected<void> Database::openConnection()
{
    if (!m_connection.open())
        return failure(ErrorCode::StorageOpen,
                       {m_file, whyNotConnected(*m_server, m_connection.lastError())});
    if (m_hangup && (m_socket = socketOf(m_connection)) >= 0)
        m_hangup->note(m_socket);
    if (const auto reason = notFit(m_connection))
        return failure(ErrorCode::StorageOpen, {m_file, *reason});
    m_lost = false;
    QStringList settings = m_dialect.settings();
    if (m_toRead)
        settings << m_dialect.onlyReading();
    for (const QString& setting : settings)
        RETURN_IF_ERROR(execute(setting, Words::tr("be opened")));
    return {};
}

void Database::closeConnection()
{
    if (m_hangup && m_socket >= 0)
        m_hangup->forget(std::exchange(m_socket, -1));
    m_connection.close();
}

Expected<void> Database::reconnectIfLost()
{
    if (!m_lost)
        return {};
    if (m_inTransaction)
        return failure(ErrorCode::StorageFailed,
                       {Words::tr("go on"), Words::tr("the server ended the connection on the way")});
    closeConnection();
    const Expected<void> opened = openConnection();
    m_lost = !opened;
    return opened;
}

} // namespace gripscope
