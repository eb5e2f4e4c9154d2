// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/library/sql/library_location.h"

#include <QCoreApplication>
#include <QFile>
#include <QSqlDatabase>
#include <QSqlError>
#include <QSqlQuery>
#include <QString>
#include <QVariant>

#include <atomic>
#include <csignal>

namespace gripscope::test {

/// The server on which this run of the tests has its libraries (support/postgresql.sh): its address is in
/// GRIPSCOPE_TEST_SERVER, or in the file that this names. Empty: they are files.
inline QString testServer()
{
    static const QString address = [] {
        const QString named = qEnvironmentVariable("GRIPSCOPE_TEST_SERVER");
        if (named.isEmpty() || LibraryLocation::isOnServer(named))
            return named;
        QFile file(named);
        if (!file.open(QIODevice::ReadOnly))
            qFatal("no server was started for this test: %s", qPrintable(named));
        return QString::fromUtf8(file.readAll()).trimmed();
    }();
    return address;
}

inline bool onServer()
{
    return !testServer().isEmpty();
}

/// Ends a test function that is about what only a file has.
#define GRIPSCOPE_OF_FILES_ALONE(reason)                                                                     \
    if (gripscope::test::onServer()) {                                                                       \
        qInfo("not on a server: " reason);                                                                   \
        return;                                                                                              \
    }

#define GRIPSCOPE_OF_SERVERS_ALONE()                                                                         \
    if (!gripscope::test::onServer()) {                                                                      \
        qInfo("of servers alone");                                                                           \
        return;                                                                                              \
    }

/// Opens a connection of the test's own; stops the program where it cannot.
inline QSqlDatabase rawConnection(const QString& place, const QString& name)
{
    const auto location = LibraryLocation::parse(place);
    if (!location)
        qFatal("%s", qPrintable(location.error().describe()));
    QSqlDatabase database = QSqlDatabase::addDatabase(
        location->server() ? QStringLiteral("QPSQL") : QStringLiteral("QSQLITE"), name);
    database.setDatabaseName(place);
    if (const auto& server = location->server()) {
        database.setHostName(server->host);
        database.setPort(server->port);
        database.setUserName(server->user);
        database.setDatabaseName(server->database);
        database.setConnectOptions(QStringLiteral("options='-c client_min_messages=error'"));
    }
    if (!database.open())
        qFatal("%s", qPrintable(database.lastError().text()));
    return database;
}

/// The address of another database of the server.
inline QString onTestServer(const QString& database)
{
    return testServer().replace(QStringLiteral("/postgres?"), u'/' + database + u'?');
}

/// A statement about databases; the first column of what it answers.
inline QStringList tellTestServer(const QString& sql)
{
    static std::atomic<int> counter = 0;
    const QString name = QStringLiteral("test-server-%1").arg(++counter);
    QStringList values;
    {
        const QSqlDatabase database = rawConnection(testServer(), name);
        QSqlQuery query(database);
        if (!query.exec(sql))
            qFatal("%s: %s", qPrintable(sql), qPrintable(query.lastError().text()));
        while (query.next())
            values += query.value(0).toString();
    }
    QSqlDatabase::removeDatabase(name);
    return values;
}

/// Ends all connections to a database but the one that says so, as a server does that is shut down.
inline void endConnectionsTo(const QString& database)
{
    tellTestServer(QStringLiteral("SELECT pg_terminate_backend(pid) FROM pg_stat_activity "
                                  "WHERE datname = '%1' AND pid <> pg_backend_pid()")
                       .arg(database));
}

inline void dropTestDatabase(const QString& name)
{
    tellTestServer(QStringLiteral("DROP DATABASE IF EXISTS %1 WITH (FORCE)").arg(name));
}

/// A database with what `prepare` makes of an empty one, once for this process; others are copies of it.
inline QString preparedDatabase(void (*prepare)(const QString& place))
{
    static const QString name = [prepare] {
        // Those of processes that have ended.
        for (const QString& left : tellTestServer(
                 QStringLiteral("SELECT datname FROM pg_database WHERE datname LIKE 'prepared_%'")))
            if (kill(pid_t(left.mid(9).toLongLong()), 0) != 0)
                dropTestDatabase(left);
        QString made = QStringLiteral("prepared_%1").arg(QCoreApplication::applicationPid());
        tellTestServer(QStringLiteral("CREATE DATABASE %1 TEMPLATE template0").arg(made));
        prepare(onTestServer(made));
        return made;
    }();
    return name;
}

/// A database of its own, dropped with it.
class TestDatabase {
public:
    explicit TestDatabase(const QString& copyOf)
    {
        static int counter = 0;
        m_name = QStringLiteral("test_%1_%2").arg(QCoreApplication::applicationPid()).arg(++counter);
        tellTestServer(QStringLiteral("CREATE DATABASE %1 TEMPLATE %2").arg(m_name, copyOf));
    }
    ~TestDatabase() { dropTestDatabase(m_name); }
    TestDatabase(const TestDatabase&) = delete;
    TestDatabase& operator=(const TestDatabase&) = delete;
    [[nodiscard]] const QString& name() const { return m_name; }
    [[nodiscard]] QString place() const { return onTestServer(m_name); }

private:
    QString m_name;
};

} // namespace gripscope::test
