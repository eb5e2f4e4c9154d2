// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/library/ledger/ledgered_tables.h"

#include <QSqlDatabase>
#include <QSqlError>
#include <QSqlQuery>
#include <QVariant>

#include <optional>
#include <random>
#include <vector>

namespace gripscope::test {

using namespace Qt::StringLiterals;

struct RandomEdit {
    QString table, row, sql;
};

/// A connection whose statements may fail.
class TamperingConnection {
public:
    explicit TamperingConnection(const QString& file)
        : m_database(QSqlDatabase::addDatabase(u"QSQLITE"_s, u"tampering"_s))
    {
        m_database.setDatabaseName(file);
        m_open = m_database.open();
    }
    ~TamperingConnection()
    {
        m_database.close();
        m_database = {};
        QSqlDatabase::removeDatabase(u"tampering"_s);
    }
    TamperingConnection(const TamperingConnection&) = delete;
    TamperingConnection& operator=(const TamperingConnection&) = delete;
    [[nodiscard]] const QSqlDatabase& database() const { return m_database; }
    /// The first column of all rows; nothing when it fails.
    [[nodiscard]] std::optional<QStringList> list(const QString& sql) const
    {
        QSqlQuery query(m_database);
        if (!m_open || !query.exec(sql))
            return {};
        QStringList values;
        while (query.next())
            values += query.value(0).toString();
        return query.lastError().isValid() ? std::nullopt : std::optional(values);
    }

private:
    QSqlDatabase m_database;
    bool m_open = false;
};

template <typename List>
auto oneOf(const List& list, std::mt19937& random)
{
    return list[std::uniform_int_distribution<int>(0, int(list.size()) - 1)(random)];
}

/// Values that somebody would write, in SQL; %1 is the column.
inline QString newValue(std::mt19937& random)
{
    static const std::vector<QString> values{u"%1 + 1"_s,
                                             u"%1 * 1.0000001"_s,
                                             u"-%1"_s,
                                             u"NULL"_s,
                                             u"0"_s,
                                             u"1"_s,
                                             u"''"_s,
                                             u"%1 || ' '"_s,
                                             u"UPPER(%1)"_s,
                                             u"'A'"_s,
                                             u"SUBSTR(%1, 2)"_s,
                                             u"CAST(%1 AS BLOB)"_s,
                                             u"CAST(%1 AS TEXT)"_s,
                                             u"X'00'"_s,
                                             u"1e308"_s,
                                             u"'2026-01-01T00:00:00.000Z'"_s,
                                             u"'supervisor'"_s,
                                             u"'approved'"_s};
    return oneOf(values, random);
}

/// A value with its type, in SQL; a number to its last bit.
inline QString exactly(const QString& column)
{
    return u"typeof(\"%1\") || CASE typeof(\"%1\") WHEN 'real' THEN printf('%!.17g', \"%1\") ELSE HEX(\"%1\") END"_s
        .arg(column);
}

/// How many random changes a test makes: GRIPSCOPE_TAMPERINGS, or 200.
inline int tamperings()
{
    const int asked = qEnvironmentVariableIntValue("GRIPSCOPE_TAMPERINGS");
    return asked > 0 ? asked : 200;
}

/// Changes one value of one row of a library past the program. Nothing where the tables refuse it or the
/// value was that already.
inline std::optional<RandomEdit> editAtRandom(const QString& file, std::mt19937& random)
{
    const TamperingConnection connection(file);
    const auto tables = ledgeredTables();
    const LedgeredTable table =
        tables[std::uniform_int_distribution<std::size_t>(0, tables.size() - 1)(random)];
    const auto keys = connection.list(u"SELECT %1 FROM %2"_s.arg(table.key, table.name));
    const auto columns = connection.list(u"SELECT name FROM pragma_table_info('%1')"_s.arg(table.name));
    if (!keys || keys->isEmpty() || !columns || columns->isEmpty())
        return {};
    RandomEdit edit{table.name, oneOf(*keys, random), {}};
    const QString column = oneOf(*columns, random);
    const QString where = u" WHERE %1 = '%2'"_s.arg(table.key, edit.row);
    const QString spelled = exactly(column);
    const auto before = connection.list(u"SELECT %1 FROM %2"_s.arg(spelled, table.name));
    edit.sql =
        u"UPDATE %1 SET %2 = %3"_s.arg(table.name, column, newValue(random).replace(u"%1"_s, column)) + where;
    if (!connection.list(edit.sql))
        return {};
    const auto after = connection.list(u"SELECT %1 FROM %2"_s.arg(spelled, table.name));
    return before == after ? std::nullopt : std::optional(edit);
}

/// All that can be read from the file: its schema and every value of every row with its type. Empty where
/// it cannot be read to the end.
inline QByteArray contentOf(const QString& file)
{
    const TamperingConnection connection(file);
    auto content =
        connection.list(u"SELECT type || name || tbl_name || COALESCE(sql, '') FROM sqlite_master"_s);
    const auto tables = connection.list(u"SELECT name FROM sqlite_master WHERE type = 'table'"_s);
    if (!content || !tables)
        return {};
    for (QString& part : *content)
        part = part.simplified(); // one blank or another between words says the same
    for (const QString& table : *tables) {
        const auto columns = connection.list(u"SELECT name FROM pragma_table_info('%1')"_s.arg(table));
        QStringList values;
        for (const QString& column : columns.value_or(QStringList()))
            values += exactly(column);
        const auto rows = connection.list(
            u"SELECT %1 FROM \"%2\" NOT INDEXED ORDER BY rowid"_s.arg(values.join(u" || ',' || "_s), table));
        if (values.isEmpty() || !rows)
            return {};
        *content += *rows;
    }
    return content->join(u'\n').toUtf8();
}

} // namespace gripscope::test
