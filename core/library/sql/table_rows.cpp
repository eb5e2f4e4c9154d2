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
    query.prepare(u"SELECT name, COALESCE(dflt_value, 'NULL') FROM pragma_table_info(?) ORDER BY name"_s);
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
    Private(Database& of, const std::vector<Column>& its)
        : database(of), columns(its), byKey(of.connection()), byNumber(of.connection()), keys(of.connection())
    {
    }
    Database& database;
    const std::vector<Column>& columns;
    QSqlQuery byKey, byNumber, keys;

    Expected<std::optional<Row>> first(QSqlQuery& query, const QVariant& value)
    {
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
    auto d = std::make_unique<Private>(database, *columns);
    QStringList names;
    for (const Column& column : *columns)
        names += quoted(column.name);
    const QString from = u" FROM "_s + quoted(table);
    const QString select = u"SELECT "_s + names.join(u", "_s) + from + u" WHERE "_s;
    const std::pair<QSqlQuery*, QString> prepared[] = {
        {&d->byKey, select + quoted(key) + u" = ?"_s},
        {&d->byNumber, select + u"rowid = ?"_s},
        {&d->keys, u"SELECT "_s + quoted(key) + from + u" ORDER BY "_s + quoted(key)},
    };
    for (const auto& [query, sql] : prepared) {
        query->setForwardOnly(true);
        if (names.isEmpty() || !query->prepare(sql))
            return database.error(query->lastError(), Words::tr("be read"));
    }
    return TableRows(std::move(d));
}

const std::vector<Column>& TableRows::columns() const
{
    return d->columns;
}

Expected<std::optional<TableRows::Row>> TableRows::withKey(const Cell& key)
{
    return d->first(d->byKey, variantOf(key));
}

Expected<std::optional<TableRows::Row>> TableRows::withRowNumber(qint64 rowNumber)
{
    return d->first(d->byNumber, QVariant(rowNumber));
}

Expected<void> TableRows::forEachKey(const std::function<bool(const Cell&)>& take)
{
    if (!d->keys.exec())
        return d->database.error(d->keys.lastError(), Words::tr("be read"));
    while (d->keys.next())
        if (!take(cellOf(d->keys.value(0))))
            break;
    if (d->keys.lastError().isValid())
        return d->database.error(d->keys.lastError(), Words::tr("be read"));
    d->keys.finish();
    return {};
}

} // namespace gripscope
