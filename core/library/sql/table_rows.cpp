// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/sql/table_rows.h"

#include "core/base/words.h"
#include "core/library/sql/database.h"

#include <QSqlError>
#include <QSqlQuery>
#include <QVariant>

#include <algorithm>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

Cell cellOf(const QVariant& value)
{
    if (value.isNull())
        return {};
    switch (value.typeId()) {
    case QMetaType::Double:
        return value.toDouble();
    case QMetaType::QString:
        return value.toString();
    case QMetaType::QByteArray:
        return value.toByteArray();
    default:
        return value.toLongLong();
    }
}

QVariant variantOf(const Cell& cell)
{
    return std::visit(
        []<typename T>(const T& value) {
            if constexpr (std::is_same_v<T, std::monostate>)
                return QVariant();
            else
                return QVariant(value);
        },
        cell);
}

QString quoted(QString name)
{
    return u'"' + name.replace(u'"', u"\"\""_s) + u'"';
}

/// The value of each default as the schema spells it.
Expected<std::vector<Cell>> valuesOf(Database& database, const QStringList& spelled)
{
    QSqlQuery query(database.connection());
    if (!query.exec(u"SELECT "_s + spelled.join(u", "_s)) || !query.next())
        return database.error(query.lastError(), Words::tr("be read"));
    std::vector<Cell> values;
    values.reserve(static_cast<std::size_t>(spelled.size()));
    for (int i = 0; i < spelled.size(); ++i)
        values.push_back(cellOf(query.value(i)));
    return values;
}

Expected<std::vector<Column>> readColumns(Database& database, const QString& table)
{
    QSqlQuery query(database.connection());
    query.prepare(database.dialect().columnsSql());
    query.addBindValue(table);
    if (!query.exec())
        return database.error(query.lastError(), Words::tr("be read"));
    std::vector<Column> columns;
    QStringList spelled;
    while (query.next()) {
        columns.push_back({query.value(0).toString(), {}});
        spelled += query.value(1).toString();
    }
    if (columns.empty())
        return columns;
    ASSIGN_OR_RETURN(const auto values, valuesOf(database, spelled));
    for (std::size_t i = 0; i < columns.size(); ++i)
        columns[i].fallback = values[i];
    return columns;
}

} // namespace

Expected<const std::vector<Column>*> columnsOf(Database& database, const QString& table)
{
    std::map<QString, std::vector<Column>>& known = database.knownColumns();
    auto found = known.find(table);
    if (found == known.end()) {
        ASSIGN_OR_RETURN(auto columns, readColumns(database, table));
        found = known.emplace(table, std::move(columns)).first;
    }
    return &found->second;
}

struct TableRows::Private {
    Database& database;
    const std::vector<Column>& columns;
    QString table, key;
    /// Each prepared when it is first asked: who writes a row wants it by its number alone.
    std::optional<QSqlQuery> byKey, byNumber;

    [[nodiscard]] Expected<QSqlQuery*> prepared(std::optional<QSqlQuery>& query, const QString& where) const
    {
        if (query)
            return &*query;
        QStringList names;
        for (const Column& column : columns)
            names += quoted(column.name);
        query.emplace(database.connection());
        query->setForwardOnly(database.dialect().streams());
        if (query->prepare(
                u"SELECT %1 FROM %2 WHERE %3 = ?"_s.arg(names.join(u", "_s), quoted(table), where)))
            return &*query;
        const auto problem = database.error(query->lastError(), Words::tr("be read"));
        query.reset();
        return problem;
    }

    [[nodiscard]] Expected<std::optional<Row>> first(const Expected<QSqlQuery*>& asked,
                                                     const QVariant& value) const
    {
        if (!asked)
            return tl::unexpected(asked.error());
        QSqlQuery& query = **asked;
        query.bindValue(0, value);
        if (!query.exec())
            return database.error(query.lastError(), Words::tr("be read"));
        std::optional<Row> row;
        if (query.next()) {
            row.emplace();
            row->reserve(columns.size());
            for (std::size_t i = 0; i < columns.size(); ++i)
                row->push_back(cellOf(query.value(static_cast<int>(i))));
        } else if (query.lastError().isValid()) {
            return database.error(query.lastError(), Words::tr("be read"));
        }
        query.finish();
        return row;
    }
};

TableRows::TableRows(std::unique_ptr<Private> p) : d(std::move(p)) {}
TableRows::~TableRows() = default;
TableRows::TableRows(TableRows&&) noexcept = default;

Expected<TableRows> TableRows::of(Database& database, const QString& table, const QString& key)
{
    ASSIGN_OR_RETURN(const auto columns, columnsOf(database, table));
    if (columns->empty())
        return failure(ErrorCode::StorageCorrupt,
                       {database.file(), Words::tr("it has no table %1").arg(table)});
    return TableRows(std::make_unique<Private>(Private{database, *columns, table, key, {}, {}}));
}

const std::vector<Column>& TableRows::columns() const
{
    return d->columns;
}

Expected<std::optional<TableRows::Row>> TableRows::withKey(const Cell& key)
{
    return d->first(d->prepared(d->byKey, quoted(d->key)), variantOf(key));
}

Expected<std::optional<TableRows::Row>> TableRows::withRowNumber(qint64 rowNumber)
{
    return d->first(d->prepared(d->byNumber, u"rowid"_s), QVariant(rowNumber));
}

Expected<void> TableRows::forEachKey(const std::function<bool(const Cell&)>& take)
{
    QSqlQuery keys(d->database.connection());
    keys.setForwardOnly(d->database.dialect().streams());
    if (!keys.exec(u"SELECT %1 FROM %2 ORDER BY %1"_s.arg(quoted(d->key), quoted(d->table))))
        return d->database.error(keys.lastError(), Words::tr("be read"));
    while (keys.next())
        if (!take(cellOf(keys.value(0))))
            break;
    if (keys.lastError().isValid())
        return d->database.error(keys.lastError(), Words::tr("be read"));
    return {};
}

} // namespace gripscope
