// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/sql/table_rows.h"

#include "core/base/words.h"
#include "core/library/sql/database.h"

#include <QSqlError>
#include <QSqlQuery>
#include <QVariant>

#include <algorithm>
#include <span>

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
            else if constexpr (std::is_same_v<T, QString>)
                return QVariant(value.isNull() ? u""_s : value); // Qt takes a null one for NULL
            else if constexpr (std::is_same_v<T, QByteArray>)
                return QVariant(value.isNull() ? QByteArray("") : value);
            else
                return QVariant(value);
        },
        cell);
}

QString quoted(QString name)
{
    return u'"' + name.replace(u'"', u"\"\""_s) + u'"';
}

/// At most so many bytes go into one statement.
constexpr std::size_t bytesOfStatement = 1 << 20;
constexpr std::size_t keysOfQuery = 500;

QString places(std::size_t number)
{
    const QStringList marks(static_cast<qsizetype>(number), u"?"_s);
    return u'(' + marks.join(u", "_s) + u')';
}

std::size_t bytesOf(const TableRows::Row& row)
{
    qsizetype bytes = 0;
    for (const Cell& cell : row) {
        if (const auto* text = std::get_if<QString>(&cell))
            bytes += text->size();
        else if (const auto* blob = std::get_if<QByteArray>(&cell))
            bytes += blob->size();
    }
    return static_cast<std::size_t>(bytes);
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
    std::optional<QSqlQuery> byKey; ///< prepared when it is first asked

    [[nodiscard]] Expected<QSqlQuery*> prepared()
    {
        if (byKey)
            return &*byKey;
        byKey.emplace(database.connection());
        byKey->setForwardOnly(database.dialect().streams());
        if (byKey->prepare(selecting() + quoted(key) + u" = ?"_s))
            return &*byKey;
        const auto problem = database.error(byKey->lastError(), Words::tr("be read"));
        byKey.reset();
        return problem;
    }

    [[nodiscard]] QString names() const
    {
        QStringList names;
        for (const Column& column : columns)
            names += quoted(column.name);
        return names.join(u", "_s);
    }
    [[nodiscard]] QString selecting() const
    {
        return u"SELECT %1, rowid FROM %2 WHERE "_s.arg(names(), quoted(table));
    }
    [[nodiscard]] Row rowOf(const QSqlQuery& query) const
    {
        Row row;
        row.reserve(columns.size());
        for (std::size_t i = 0; i < columns.size(); ++i)
            row.push_back(cellOf(query.value(static_cast<int>(i))));
        return row;
    }
    [[nodiscard]] std::size_t indexOfKey() const
    {
        const auto found = std::ranges::find(columns, key, &Column::name);
        return static_cast<std::size_t>(found - columns.begin());
    }
    /// Each row that `where` is true of, with its number.
    [[nodiscard]] Expected<void> forEach(const QString& where, std::span<const Cell> values,
                                         const std::function<void(Row, qint64)>& take) const
    {
        QSqlQuery query(database.connection());
        query.setForwardOnly(database.dialect().streams());
        query.prepare(selecting() + where);
        for (const Cell& value : values)
            query.addBindValue(variantOf(value));
        if (!query.exec())
            return database.error(query.lastError(), Words::tr("be read"));
        while (query.next())
            take(rowOf(query), query.value(static_cast<int>(columns.size())).toLongLong());
        if (query.lastError().isValid())
            return database.error(query.lastError(), Words::tr("be read"));
        return {};
    }
    [[nodiscard]] Expected<void> insert(std::span<const Row> rows, const QString& doing,
                                        std::set<Cell>& inserted) const;

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
            row = rowOf(query);
        } else if (query.lastError().isValid()) {
            return database.error(query.lastError(), Words::tr("be read"));
        }
        query.finish();
        return row;
    }
};

Expected<void> TableRows::Private::insert(std::span<const Row> rows, const QString& doing,
                                          std::set<Cell>& inserted) const
{
    const QStringList valuesOfRows(static_cast<qsizetype>(rows.size()), places(columns.size()));
    const SqlDialect& dialect = database.dialect();
    QSqlQuery query(database.connection());
    query.setForwardOnly(dialect.streams());
    query.prepare(u"INSERT INTO %1 (%2) VALUES %3 ON CONFLICT DO NOTHING RETURNING %4, rowid"_s.arg(
        quoted(table), names(), valuesOfRows.join(u", "_s), quoted(key)));
    for (const Row& row : rows)
        for (const Cell& cell : row) {
            const auto* text = std::get_if<QString>(&cell);
            if (const auto refused = text ? database.whyNotStored(*text, doing) : std::nullopt)
                return tl::unexpected(*refused);
            const auto* number = std::get_if<double>(&cell);
            query.addBindValue(number ? dialect.bound(*number) : variantOf(cell));
        }
    if (!query.exec())
        return database.error(query.lastError(), doing);
    while (query.next()) {
        inserted.insert(cellOf(query.value(0)));
        database.noteInserted({table, query.value(1).toLongLong()});
    }
    if (query.lastError().isValid())
        return database.error(query.lastError(), doing);
    return {};
}

TableRows::TableRows(std::unique_ptr<Private> p) : d(std::move(p)) {}
TableRows::~TableRows() = default;
TableRows::TableRows(TableRows&&) noexcept = default;

Expected<TableRows> TableRows::of(Database& database, const QString& table, const QString& key)
{
    ASSIGN_OR_RETURN(const auto columns, columnsOf(database, table));
    if (columns->empty())
        return failure(ErrorCode::StorageCorrupt,
                       {database.file(), Words::tr("it has no table %1").arg(table)});
    return TableRows(std::make_unique<Private>(Private{database, *columns, table, key, {}}));
}

const std::vector<Column>& TableRows::columns() const
{
    return d->columns;
}

Expected<std::optional<TableRows::Row>> TableRows::withKey(const Cell& key)
{
    return d->first(d->prepared(), variantOf(key));
}

Expected<std::map<Cell, TableRows::Row>> TableRows::withKeys(const std::vector<Cell>& keys)
{
    std::map<Cell, Row> found;
    const std::size_t index = d->indexOfKey();
    for (std::size_t first = 0; first < keys.size(); first += keysOfQuery) {
        const std::span<const Cell> some(keys.data() + first, std::min(keysOfQuery, keys.size() - first));
        RETURN_IF_ERROR(
            d->forEach(quoted(d->key) + u" IN "_s + places(some.size()), some, [&](Row row, qint64) {
                const Cell key = row[index];
                found[key] = std::move(row);
            }));
    }
    return found;
}

Expected<std::map<qint64, TableRows::Row>> TableRows::withRowNumbers(const std::vector<qint64>& rowNumbers)
{
    std::map<qint64, Row> found;
    for (std::size_t first = 0; first < rowNumbers.size(); first += keysOfQuery) {
        QStringList numbers;
        for (std::size_t i = first; i < std::min(first + keysOfQuery, rowNumbers.size()); ++i)
            numbers += QString::number(rowNumbers[i]);
        RETURN_IF_ERROR(d->forEach(u"rowid IN ("_s + numbers.join(u',') + u')', {},
                                   [&](Row row, qint64 number) { found[number] = std::move(row); }));
    }
    return found;
}

Expected<std::set<Cell>> TableRows::insert(const std::vector<Row>& rows, const QString& doing)
{
    std::set<Cell> inserted;
    const std::size_t most =
        std::max(std::size_t(1), d->database.dialect().valuesOfStatement() / d->columns.size());
    for (std::size_t first = 0; first < rows.size();) {
        std::size_t number = 0, bytes = 0;
        while (first + number < rows.size() && number < most && (number == 0 || bytes < bytesOfStatement))
            bytes += bytesOf(rows[first + number++]);
        RETURN_IF_ERROR(d->insert(std::span(rows).subspan(first, number), doing, inserted));
        first += number;
    }
    return inserted;
}

Expected<void> TableRows::insertAll(const std::vector<Row>& rows, const QString& doing)
{
    ASSIGN_OR_RETURN(const auto inserted, insert(rows, doing));
    if (inserted.size() != rows.size())
        return failure(ErrorCode::StorageFailed, {doing, Words::tr("it is there already")});
    return {};
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
