// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/words.h"
#include "core/library/sql/server_words.h"
#include "core/library/sql/sql_dialect.h"

#include <QRegularExpression>
#include <QSqlError>

#include <cmath>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

const auto ownSchema = u"(SELECT oid FROM pg_namespace WHERE nspname = current_schema())"_s;

/// Columns, constraints, indexes; and what acts by itself, which no migration makes. Without the name of the
/// schema, which another one may have.
QString serverPartsSql()
{
    return u"WITH own AS (SELECT %1 AS schema), tables AS (SELECT c.oid, c.relname, c.relkind, "
           "c.relrowsecurity FROM pg_class c, own WHERE c.relnamespace = own.schema) "
           "SELECT 'column' AS type, t.relname || '.' || a.attname AS name, t.relname::text, "
           "convert_to(concat_ws(' ', format_type(a.atttypid, a.atttypmod), l.collname, a.attnotnull, "
           "a.attidentity, a.attgenerated, pg_get_expr(d.adbin, d.adrelid)), 'UTF8') "
           "FROM tables t JOIN pg_attribute a ON a.attrelid = t.oid AND a.attnum > 0 AND NOT a.attisdropped "
           "LEFT JOIN pg_attrdef d ON d.adrelid = a.attrelid AND d.adnum = a.attnum "
           "LEFT JOIN pg_collation l ON l.oid = a.attcollation WHERE t.relkind = 'r' "
           "UNION ALL SELECT 'constraint', n.conname, t.relname, convert_to(pg_get_constraintdef(n.oid), "
           "'UTF8') FROM pg_constraint n JOIN tables t ON t.oid = n.conrelid "
           "UNION ALL SELECT 'index', i.relname, t.relname, convert_to(x.indisvalid::text || ' ' || "
           "replace(replace(pg_get_indexdef(x.indexrelid), quote_ident(s.nspname) || '.', ''), 'pg_temp.', "
           "''), "
           "'UTF8') "
           "FROM pg_index x JOIN tables t ON t.oid = x.indrelid JOIN pg_class i ON i.oid = x.indexrelid "
           "JOIN pg_namespace s ON s.oid = i.relnamespace "
           "UNION ALL SELECT 'table', t.relname, t.relname, convert_to(t.relrowsecurity::text, 'UTF8') "
           "FROM tables t WHERE t.relkind IN ('r', 'p') "
           "UNION ALL SELECT 'view', t.relname, t.relname, ''::bytea FROM tables t "
           "WHERE t.relkind IN ('v', 'm', 'f') "
           "UNION ALL SELECT 'trigger', g.tgname, t.relname, convert_to(pg_get_triggerdef(g.oid), 'UTF8') "
           "FROM pg_trigger g JOIN tables t ON t.oid = g.tgrelid WHERE NOT g.tgisinternal "
           "UNION ALL SELECT 'rule', r.rulename, t.relname, convert_to(pg_get_ruledef(r.oid), 'UTF8') "
           "FROM pg_rewrite r JOIN tables t ON t.oid = r.ev_class WHERE t.relkind = 'r'"_s.arg(ownSchema);
}

class PostgresqlDialect final : public SqlDialect {
public:
    QString driver() const override { return u"QPSQL"_s; }
    QString driverMissing() const override
    {
        return Words::tr("Qt's PostgreSQL driver is not installed; on Debian: apt install %1")
            .arg(driverPackage());
    }
    QString driverPackage() const override { return u"libqt6sql6-psql"_s; }
    QStringList settings() const override
    {
        // Together, since each costs a way to the server and back. What was stored survives a power cut of
        // the server, whatever its own setting; and no statement, lock or idle transaction lasts for ever.
        return {u"SET client_min_messages = error; SET jit = off; SET bytea_output = hex; "
                "SET extra_float_digits = 3; SET standard_conforming_strings = on; "
                "SET lock_timeout = %1; SET statement_timeout = '5min'; "
                "SET idle_in_transaction_session_timeout = '5min'; "
                "SELECT set_config('synchronous_commit', 'on', false) "
                "WHERE current_setting('synchronous_commit') = 'off'"_s.arg(sqlBusyTimeout_ms)};
    }
    QString onlyReading() const override { return u"SET default_transaction_read_only = on"_s; }

    QString ofMigration(const QString& statement) const override
    {
        // Texts are compared by their bytes whatever the database's own language, and rows have the number
        // that SQLite gives by itself.
        static const QRegularExpression text(u"\\bTEXT\\b"_s);
        QString sql = QString(statement).replace("{blob}"_L1, "BYTEA"_L1);
        const bool makesTable = sql.startsWith("CREATE TABLE "_L1);
        if (makesTable || sql.startsWith("ALTER TABLE "_L1))
            sql.replace(text, u"TEXT COLLATE \"C\""_s);
        if (makesTable)
            sql.insert(sql.lastIndexOf(u')'), u", rowid BIGINT GENERATED ALWAYS AS IDENTITY UNIQUE"_s);
        return sql;
    }
    QString spelled(const QString& sql) const override
    {
        return QString(sql).replace(" LIKE "_L1, " ILIKE "_L1);
    }
    QString answersRowNumber() const override { return u" RETURNING rowid"_s; }
    bool streams() const override { return false; }
    QVariant bound(double number) const override
    {
        // Unquoted, -0 would be an integer.
        return number == 0 && std::signbit(number) ? QVariant(u"-0"_s) : QVariant(number);
    }
    bool takesText(const QString& text) const override { return !text.contains(QChar::Null); }
    std::size_t valuesOfStatement() const override { return 8'000; } // each costs a way to the server

    QString tablesSql() const override
    {
        return u"SELECT c.relname::text FROM pg_class c WHERE c.relkind IN ('r', 'p') AND c.relnamespace = "
               "%1 ORDER BY c.relname"_s.arg(ownSchema);
    }
    QString columnsSql() const override
    {
        return u"SELECT a.attname::text, COALESCE(pg_get_expr(d.adbin, d.adrelid), 'NULL') "
               "FROM pg_attribute a JOIN pg_class c ON c.oid = a.attrelid LEFT JOIN pg_attrdef d ON "
               "d.adrelid "
               "= a.attrelid AND d.adnum = a.attnum WHERE c.relname = ? AND c.relnamespace = %1 AND "
               "a.attnum > 0 AND NOT a.attisdropped AND a.attname <> 'rowid' ORDER BY a.attname"_s.arg(
                   ownSchema);
    }
    QString partsSql() const override { return serverPartsSql(); }

    QString beginReading() const override { return u"BEGIN ISOLATION LEVEL REPEATABLE READ READ ONLY"_s; }
    QStringList beginWriting() const override
    {
        // One lock for all that writes to the library (any number will do): MAX(...) + 1 and the ledger rest
        // on one writer at a time. What is read afterwards is as the writer before left it.
        return {u"BEGIN; SELECT pg_advisory_xact_lock(7453010373645639777)"_s};
    }

    SqlFailure failureOf(const QSqlError& error) const override { return serverFailure(error); }
};

} // namespace

const SqlDialect& SqlDialect::postgresql()
{
    static const PostgresqlDialect dialect;
    return dialect;
}

} // namespace gripscope
