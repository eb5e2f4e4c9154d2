// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/ledger/merged_rows.h"

#include "core/base/words.h"
#include "core/library/sql/rows.h"

#include <QJsonDocument>
#include <QJsonObject>

#include <algorithm>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

QString readingViews()
{
    return Words::tr("read the rows of other stations");
}

constexpr int digitsOfDouble = 17;

/// The bits of a number survive as text.
QJsonValue asJson(const Cell& cell)
{
    if (const auto* integer = std::get_if<qint64>(&cell))
        return u"i%1"_s.arg(*integer);
    if (const auto* number = std::get_if<double>(&cell))
        return u'd' + QString::number(*number, 'g', digitsOfDouble);
    if (const auto* text = std::get_if<QString>(&cell))
        return u't' + *text;
    if (const auto* bytes = std::get_if<QByteArray>(&cell))
        return u'b' + QString::fromLatin1(bytes->toBase64());
    return QJsonValue::Null;
}

std::optional<Cell> fromJson(const QJsonValue& value)
{
    if (value.isNull())
        return Cell();
    const QString text = value.toString();
    if (text.isEmpty())
        return {};
    const QString rest = text.mid(1);
    bool isRight = true;
    Cell cell;
    switch (text.front().unicode()) {
    case u'i':
        cell = rest.toLongLong(&isRight);
        break;
    case u'd':
        cell = rest.toDouble(&isRight);
        break;
    case u't':
        cell = rest;
        break;
    case u'b':
        cell = rest.isEmpty() ? QByteArray("") : QByteArray::fromBase64(rest.toLatin1());
        break;
    default:
        isRight = false;
    }
    return isRight ? std::optional(cell) : std::nullopt;
}

QString compact(const QJsonObject& object)
{
    return object.isEmpty() ? QString()
                            : QString::fromUtf8(QJsonDocument(object).toJson(QJsonDocument::Compact));
}

MergedRow takeMergedRow(Statement& row)
{
    MergedRow merged;
    merged.library = row.takeText();
    merged.table = static_cast<quint8>(row.takeInteger());
    merged.key = row.takeText();
    merged.number = row.takeInteger();
    merged.isOrigin = row.takeInteger() != 0;
    merged.whole = row.takeInteger() != 0;
    merged.content = row.takeText();
    return merged;
}

const auto selectMergedRows =
    u"SELECT library, table_code, row_key, number, is_origin, whole, content FROM merged_rows "_s;

} // namespace

bool isOfMerge(const std::vector<LedgerLeaf>& link)
{
    const quint8 meetings = ledgeredTable(u"library_meetings"_s)->code;
    return std::ranges::any_of(link, [meetings](const LedgerLeaf& leaf) { return leaf.table == meetings; });
}

namespace merged_rows {

Expected<void> insert(Database& database, const std::vector<MergedRow>& rows)
{
    if (rows.empty())
        return {};
    ASSIGN_OR_RETURN(TableRows table, TableRows::of(database, u"merged_rows"_s, u"rowid"_s));
    std::vector<TableRows::Row> cells;
    cells.reserve(rows.size());
    for (const MergedRow& row : rows)
        cells.push_back(rowWith(table.columns(), {{u"library", row.library},
                                                  {u"table_code", qint64(row.table)},
                                                  {u"row_key", row.key},
                                                  {u"number", row.number},
                                                  {u"is_origin", qint64(row.isOrigin)},
                                                  {u"whole", qint64(row.whole)},
                                                  {u"content", row.content}}));
    return table.insertAll(cells, Words::tr("take a row of another station"));
}

Expected<std::optional<MergedRow>> find(Database& database, const QString& library, quint8 table,
                                        const QString& key)
{
    Statement query(database, readingViews(),
                    selectMergedRows + u"WHERE library = ? AND table_code = ? AND row_key = ?"_s);
    return firstRow(query.bind(library).bind(int(table)).bind(key), takeMergedRow);
}

Expected<std::map<QString, qint64>> numbers(Database& database, const QString& library, quint8 table,
                                            bool whole)
{
    std::map<QString, qint64> numbers;
    Statement query(
        database, readingViews(),
        u"SELECT row_key, number FROM merged_rows WHERE library = ? AND table_code = ? AND whole = ?"_s);
    const auto done = query.bind(library).bind(int(table)).bind(whole ? 1 : 0).forEach([&](Statement& row) {
        const QString key = row.takeText();
        numbers[key] = row.takeInteger();
    });
    if (!done)
        return tl::unexpected(done.error());
    return numbers;
}

Expected<qint64> count(Database& database)
{
    Statement query(database, readingViews(), u"SELECT COUNT(*) FROM merged_rows"_s);
    return numberOf(query);
}

Expected<qint64> ofOtherKinds(Database& database)
{
    if (database.isOnServer()) // a column there takes nothing else
        return 0;
    Statement query(
        database, readingViews(),
        u"SELECT COUNT(*) FROM merged_rows WHERE typeof(library) || typeof(table_code) || "
        "typeof(row_key) || typeof(number) || typeof(is_origin) || typeof(whole) || typeof(content) "
        "<> 'textintegertextintegerintegerintegertext' OR is_origin NOT IN (0, 1) OR whole NOT IN "
        "(0, 1)"_s);
    return numberOf(query);
}

QString contentOf(const std::vector<Column>& columns, const TableRows::Row& row)
{
    QJsonObject object;
    for (std::size_t i = 0; i < columns.size(); ++i)
        object.insert(columns[i].name, asJson(row[i]));
    return compact(object);
}

QString difference(const std::vector<Column>& columns, const TableRows::Row& there,
                   const TableRows::Row& here)
{
    QJsonObject object;
    for (std::size_t i = 0; i < columns.size(); ++i)
        if (there[i] != here[i])
            object.insert(columns[i].name, asJson(there[i]));
    return compact(object);
}

bool apply(const QString& content, const std::vector<Column>& columns, TableRows::Row& row)
{
    // To the letter as it is written, so that nothing in it can be changed unseen.
    const QJsonObject object = QJsonDocument::fromJson(content.toUtf8()).object();
    if (compact(object) != content)
        return false;
    for (auto value = object.begin(); value != object.end(); ++value) {
        const std::optional<Cell> cell = fromJson(value.value());
        const bool isColumn = std::ranges::find(columns, value.key(), &Column::name) != columns.end();
        if (!cell || !isColumn || asJson(*cell) != value.value())
            return false;
        setCell(columns, row, value.key(), *cell);
    }
    return true;
}

} // namespace merged_rows

Cell cellIn(const std::vector<Column>& columns, const TableRows::Row& row, QStringView column)
{
    for (std::size_t i = 0; i < columns.size(); ++i)
        if (columns[i].name == column)
            return row[i];
    return {};
}

qint64 integerIn(const std::vector<Column>& columns, const TableRows::Row& row, QStringView column)
{
    const Cell cell = cellIn(columns, row, column);
    const auto* integer = std::get_if<qint64>(&cell);
    return integer != nullptr ? *integer : 0;
}

QString textIn(const std::vector<Column>& columns, const TableRows::Row& row, QStringView column)
{
    const Cell cell = cellIn(columns, row, column);
    const auto* text = std::get_if<QString>(&cell);
    return text != nullptr ? *text : QString();
}

TableRows::Row rowWith(const std::vector<Column>& columns,
                       std::initializer_list<std::pair<QStringView, Cell>> values)
{
    TableRows::Row row(columns.size());
    for (const auto& [column, value] : values)
        setCell(columns, row, column, value);
    return row;
}

void setCell(const std::vector<Column>& columns, TableRows::Row& row, QStringView column, const Cell& value)
{
    for (std::size_t i = 0; i < columns.size(); ++i)
        if (columns[i].name == column)
            row[i] = value;
}

Expected<TableRows*> RowViews::rowsOf(const LedgeredTable& table)
{
    auto found = m_tables.find(table.code);
    if (found == m_tables.end()) {
        ASSIGN_OR_RETURN(TableRows rows, TableRows::of(m_database, table.name, table.key));
        found = m_tables.emplace(table.code, std::move(rows)).first;
    }
    return &found->second;
}

Expected<const std::vector<Column>*> RowViews::columns(const LedgeredTable& table)
{
    ASSIGN_OR_RETURN(TableRows * rows, rowsOf(table));
    return &rows->columns();
}

Expected<std::optional<TableRows::Row>> RowViews::own(const LedgeredTable& table, const Cell& key)
{
    ASSIGN_OR_RETURN(TableRows * rows, rowsOf(table));
    return rows->withKey(key);
}

Expected<std::optional<RowViews::View>> RowViews::rowIn(const QString& library, const LedgeredTable& table,
                                                        const Cell& key)
{
    std::optional<MergedRow> merged;
    if (library != m_own) {
        ASSIGN_OR_RETURN(merged, merged_rows::find(m_database, library, table.code, keyText(key)));
    }
    ASSIGN_OR_RETURN(TableRows * rows, rowsOf(table));
    std::optional<TableRows::Row> row;
    if (merged && merged->whole) {
        row.emplace();
        for (const Column& column : rows->columns())
            row->push_back(column.fallback);
    } else {
        ASSIGN_OR_RETURN(row, rows->withKey(key));
    }
    if (!row || (merged && !merged_rows::apply(merged->content, rows->columns(), *row)))
        return std::nullopt;
    return View{std::move(*row), std::move(merged)};
}

} // namespace gripscope
