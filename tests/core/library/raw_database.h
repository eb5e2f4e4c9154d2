// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/library/sql/sql_dialect.h"
#include "tests/core/library/test_server.h"

#include <QRegularExpression>
#include <QSqlDatabase>
#include <QSqlError>
#include <QSqlQuery>
#include <QSqlRecord>
#include <QString>
#include <QVariant>

namespace gripscope::test {

/// A statement of a test, written for SQLite, as the server that the tests run on takes it.
inline QString rawSql(const QString& sql)
{
    if (!onServer())
        return sql;
    static const QRegularExpression bytes(QStringLiteral("\\b[xX]'([0-9A-Fa-f]*)'"));
    QString spelled = sql;
    spelled.replace(bytes, QStringLiteral("'\\x\\1'::bytea"));
    const bool changesTables =
        sql.startsWith(QStringLiteral("CREATE TABLE ")) || sql.startsWith(QStringLiteral("ALTER TABLE "));
    if (!changesTables)
        return spelled;
    return SqlDialect::postgresql().ofMigration(
        spelled.replace(QStringLiteral(" BLOB"), QStringLiteral(" {blob}")));
}

/// A connection of the test's own, past the library, to prepare files and to look into them.
class RawDatabase {
public:
    explicit RawDatabase(const QString& place)
        : m_name(QStringLiteral("raw-%1").arg(quintptr(this))), m_database(rawConnection(place, m_name))
    {
    }
    ~RawDatabase()
    {
        m_database = {};
        QSqlDatabase::removeDatabase(m_name);
    }
    RawDatabase(const RawDatabase&) = delete;
    RawDatabase& operator=(const RawDatabase&) = delete;

    /// Runs a statement; the first value of its first row.
    QVariant run(const QString& sql)
    {
        QSqlQuery query(m_database);
        if (!query.exec(rawSql(sql)))
            qFatal("%s: %s", qPrintable(sql), qPrintable(query.lastError().text()));
        return query.next() ? query.value(0) : QVariant();
    }
    qint64 count(const QString& table)
    {
        return run(QStringLiteral("SELECT COUNT(*) FROM ") + table).toLongLong();
    }
    QStringList column(const QString& sql)
    {
        QSqlQuery query(m_database);
        QStringList values;
        for (query.exec(rawSql(sql)); query.next();)
            values += query.value(query.record().count() - 1).toString();
        return values;
    }

private:
    QString m_name;
    QSqlDatabase m_database;
};

/// Makes a table take no row any more once it has so many.
inline void takeNoMoreThan(int rows, const QString& table, const QString& place)
{
    RawDatabase raw(place);
    if (!onServer()) {
        raw.run(
            QStringLiteral("CREATE TRIGGER refuse BEFORE INSERT ON %1 WHEN (SELECT COUNT(*) FROM %1) >= %2 "
                           "BEGIN SELECT RAISE(ABORT, 'no'); END")
                .arg(table)
                .arg(rows));
        return;
    }
    raw.run(QStringLiteral("CREATE FUNCTION refuse() RETURNS trigger LANGUAGE plpgsql AS $$BEGIN "
                           "IF (SELECT COUNT(*) FROM %1) >= %2 THEN RAISE 'no'; END IF; RETURN NEW; END$$")
                .arg(table)
                .arg(rows));
    raw.run(QStringLiteral("CREATE TRIGGER refuse BEFORE INSERT ON %1 FOR EACH ROW EXECUTE FUNCTION refuse()")
                .arg(table));
}

} // namespace gripscope::test
