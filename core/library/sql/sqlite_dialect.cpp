// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/words.h"
#include "core/library/sql/sql_dialect.h"

#include <QSqlError>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

/// SQLite's primary result codes (sqlite.org/rescode.html).
enum SqliteCode {
    Busy = 5,
    Locked = 6,
    ReadOnly = 8,
    IoError = 10,
    Corrupt = 11,
    Full = 13,
    CantOpen = 14,
    NotADatabase = 26
};

class SqliteDialect final : public SqlDialect {
public:
    QString driver() const override { return u"QSQLITE"_s; }
    QString driverMissing() const override { return Words::tr("Qt's SQLite driver is not installed"); }
    QString driverPackage() const override { return u"libqt6sql6-sqlite"_s; }
    QStringList settings() const override
    {
        // With the usual 2 MB of pages a library of a hundred thousand squeezes is read from the disk again
        // and again. The file may be anybody's: what its schema says is not run, and a cell that lies about
        // its size is an error.
        return {u"PRAGMA trusted_schema=OFF"_s, u"PRAGMA cell_size_check=ON"_s, u"PRAGMA foreign_keys=ON"_s,
                u"PRAGMA cache_size=-65536"_s};
    }
    QString onlyReading() const override { return u"PRAGMA query_only=ON"_s; }
    QString ofMigration(const QString& statement) const override
    {
        return QString(statement).replace("{blob}"_L1, "BLOB"_L1);
    }
    QString spelled(const QString& sql) const override { return sql; }
    QString answersRowNumber() const override { return {}; }
    bool streams() const override { return true; }
    QVariant bound(double number) const override { return number; }
    bool takesText(const QString&) const override { return true; }
    // Qt gives each a name, and SQLite compares it with all names before: ten thousand take seconds.
    std::size_t valuesOfStatement() const override { return 200; }
    QString tablesSql() const override
    {
        return u"SELECT name FROM sqlite_master WHERE type = 'table' ORDER BY name"_s;
    }
    QString columnsSql() const override
    {
        return u"SELECT name, COALESCE(dflt_value, 'NULL') FROM pragma_table_info(?) ORDER BY name"_s;
    }
    QString partsSql() const override
    {
        // As bytes: as text, what is no blank may look like one.
        return u"SELECT type, name, tbl_name, CAST(COALESCE(sql, '') AS BLOB) FROM sqlite_master "
               "WHERE name NOT LIKE 'sqlite!_stat_' ESCAPE '!'"_s;
    }
    QString beginReading() const override { return u"BEGIN"_s; }
    QStringList beginWriting() const override { return {u"BEGIN IMMEDIATE"_s}; }
    SqlFailure failureOf(const QSqlError& error) const override;
};

SqlFailure SqliteDialect::failureOf(const QSqlError& error) const
{
    using Kind = SqlFailure::Kind;
    switch (error.nativeErrorCode().toInt() & 0xff) { // the higher bits only refine it
    case Busy:
    case Locked:
        return {Kind::Busy,
                Words::tr("another program kept it locked for %1 s").arg(sqlBusyTimeout_ms / 1000)};
    case ReadOnly:
        return {Kind::Failed, Words::tr("the file or its folder is write-protected")};
    case IoError:
        return {Kind::Failed, Words::tr("the disk reports an error")};
    case Full:
        return {Kind::Failed, Words::tr("the disk is full")};
    case Corrupt:
    case NotADatabase:
        return {Kind::Corrupt, error.databaseText()};
    case CantOpen:
        return {Kind::CannotBe,
                Words::tr("the file or its folder is missing or may not be opened or written")};
    default:
        return {Kind::Failed, error.databaseText().isEmpty() ? error.driverText() : error.databaseText()};
    }
}

} // namespace

const SqlDialect& SqlDialect::sqlite()
{
    static const SqliteDialect dialect;
    return dialect;
}

} // namespace gripscope
