// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QSqlDatabase>
#include <QSqlError>
#include <QSqlQuery>
#include <QSqlRecord>
#include <QString>
#include <QVariant>

namespace gripscope::test {

/// A connection of the test's own, past the library, to prepare files and to look into them.
class RawDatabase {
public:
    explicit RawDatabase(const QString& file)
        : m_name(QStringLiteral("raw-%1").arg(quintptr(this))),
          m_database(QSqlDatabase::addDatabase(QStringLiteral("QSQLITE"), m_name))
    {
        m_database.setDatabaseName(file);
        if (!m_database.open())
            qFatal("%s", qPrintable(m_database.lastError().text()));
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
        if (!query.exec(sql))
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
        for (query.exec(sql); query.next();)
            values += query.value(query.record().count() - 1).toString();
        return values;
    }

private:
    QString m_name;
    QSqlDatabase m_database;
};

} // namespace gripscope::test
