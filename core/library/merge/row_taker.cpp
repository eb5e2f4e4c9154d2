// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/merge/row_taker.h"

#include "core/base/words.h"
#include "core/library/ledger/row_digest.h"
#include "core/library/plant/plant_history.h"
#include "core/library/sql/rows.h"

#include <algorithm>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

QString takingRows()
{
    return Words::tr("take the rows of another station");
}

void bindCell(Statement& statement, const Cell& cell)
{
    if (const auto* integer = std::get_if<qint64>(&cell))
        statement.bind(*integer);
    else if (const auto* number = std::get_if<double>(&cell))
        statement.bind(*number);
    else if (const auto* text = std::get_if<QString>(&cell))
        statement.bind(*text);
    else if (const auto* bytes = std::get_if<QByteArray>(&cell))
        statement.bindBytes(*bytes);
    else
        statement.bindOptional(std::optional<QString>());
}

/// Rows by which types and enrolled squeezes become other than they were.
bool isChange(const QString& table)
{
    return table == u"library_changes" || table == u"type_states" || table == u"types" ||
           table == u"placements";
}

} // namespace

qint64 TakenRows::sum() const
{
    qint64 sum = 0;
    for (const auto& [table, rows] : byTable)
        sum += rows;
    return sum;
}

RowTaker::RowTaker(Database& source, const QString& sourceId, Database& target, const QString& targetId)
    : m_source(source), m_target(target), m_there(source, sourceId), m_here(target, targetId),
      m_views(source, sourceId)
{
}

Expected<TableRows::Row> RowTaker::rowThere(const LedgeredTable& table, const NewLeaf& leaf)
{
    ASSIGN_OR_RETURN(const auto columns, m_there.columns(table));
    ASSIGN_OR_RETURN(auto view, m_there.rowIn(leaf.library, table, leaf.leaf.key));
    if (view && rowDigest(*columns, view->row) == leaf.leaf.digest)
        return std::move(view->row);
    return failure(
        ErrorCode::StorageCorrupt,
        {m_source.file(),
         Words::tr("row %2 of %1 is not what its ledger says").arg(table.name, keyText(leaf.leaf.key))});
}

Expected<void> RowTaker::giveVersions(const std::vector<NewLeaf>& changes)
{
    const TakenTable& table = *std::ranges::find(takenTables(), u"library_changes"_s, &TakenTable::name);
    Statement known(m_target, takingRows(), u"SELECT id, version FROM library_changes"_s);
    qint64 newest = 0;
    RETURN_IF_ERROR(known.forEach([&](Statement& row) {
        const QString key = row.takeText();
        m_versions[key] = row.takeInteger();
        newest = std::max(newest, m_versions[key]);
    }));
    ASSIGN_OR_RETURN(const auto columns, m_there.columns(table.ledgered()));
    std::vector<ChangeStamp> stamps;
    for (const NewLeaf& leaf : changes) {
        if (!leaf.madeThere) // it is in the ledger of the library that it was made in, too
            continue;
        ASSIGN_OR_RETURN(const auto row, rowThere(table.ledgered(), leaf));
        const QString key = keyText(leaf.leaf.key);
        const bool isMeeting = textIn(*columns, row, u"kind") == toString(ChangeKind::Meeting);
        if (!isMeeting && !m_versions.contains(key))
            stamps.push_back({leaf.library, integerIn(*columns, row, u"version"),
                              textIn(*columns, row, u"changed_utc"), textIn(*columns, row, u"station"), key});
    }
    if (stamps.empty())
        return {};
    std::ranges::sort(stamps, comesBefore);
    // What is changed here from now on has a version behind all that was seen.
    newest = std::max(newest, stamps.back().version - static_cast<qint64>(stamps.size()));
    for (const ChangeStamp& stamp : stamps)
        m_versions[stamp.row] = ++newest;
    return {};
}

Expected<void> RowTaker::take(const TakenTable& table, const std::vector<NewLeaf>& leaves)
{
    for (const NewLeaf& leaf : leaves)
        RETURN_IF_ERROR(takeOne(table, leaf));
    return {};
}

Expected<void> RowTaker::takeOne(const TakenTable& table, const NewLeaf& leaf)
{
    const LedgeredTable& ledgered = table.ledgered();
    ASSIGN_OR_RETURN(const auto columns, m_there.columns(ledgered));
    ASSIGN_OR_RETURN(const TableRows::Row there, rowThere(ledgered, leaf));
    ASSIGN_OR_RETURN(const LibraryView* view, m_views.of(leaf.library));
    const bool followsOnly =
        (table.name == u"library_changes" &&
         textIn(*columns, there, u"kind") == toString(ChangeKind::Meeting)) ||
        (table.version == u"version" && view->meetings.contains(integerIn(*columns, there, u"version")));
    if (table.kind == TakenTable::Kind::ForTheRecord || followsOnly)
        return keepForTheRecord(table, leaf, *columns, there);
    ASSIGN_OR_RETURN(auto here, m_here.own(ledgered, leaf.leaf.key));
    if (!here) {
        TableRows::Row adapted = there;
        RETURN_IF_ERROR(adapt(table, leaf.library, *columns, adapted));
        RETURN_IF_ERROR(insert(table, *columns, adapted));
        ASSIGN_OR_RETURN(here, m_here.own(ledgered, leaf.leaf.key));
        if (!here) // something here excludes it, such as two ends of one batch
            return keepForTheRecord(table, leaf, *columns, there);
        ++m_taken.byTable[table.name];
        m_taken.hasChanges = m_taken.hasChanges || isChange(table.name);
    }
    return keep(table, leaf, *columns, there, *here);
}

Expected<void> RowTaker::keep(const TakenTable& table, const NewLeaf& leaf, const Columns& columns,
                              const TableRows::Row& there, const TableRows::Row& here)
{
    MergedRow merged;
    merged.content = merged_rows::difference(columns, there, here);
    if (merged.content.isEmpty() && table.number.isEmpty())
        return {};
    merged.library = leaf.library;
    merged.table = table.ledgered().code;
    merged.key = keyText(leaf.leaf.key);
    if (!table.number.isEmpty()) {
        merged.number = integerIn(columns, there, table.number);
        merged.isOrigin = leaf.madeThere;
    }
    return merged_rows::insert(m_target, merged);
}

Expected<void> RowTaker::keepForTheRecord(const TakenTable& table, const NewLeaf& leaf,
                                          const Columns& columns, const TableRows::Row& there)
{
    ++m_taken.forTheRecord;
    MergedRow merged;
    merged.library = leaf.library;
    merged.table = table.ledgered().code;
    merged.key = keyText(leaf.leaf.key);
    merged.number = table.number.isEmpty() ? 0 : integerIn(columns, there, table.number);
    merged.whole = true;
    merged.content = merged_rows::contentOf(columns, there);
    return merged_rows::insert(m_target, merged);
}

Expected<void> RowTaker::adapt(const TakenTable& table, const QString& library, const Columns& columns,
                               TableRows::Row& row)
{
    ASSIGN_OR_RETURN(const LibraryView* view, m_views.of(library));
    const auto integer = [&](QStringView column) { return integerIn(columns, row, column); };
    const auto set = [&](QStringView column, const Cell& value) { setCell(columns, row, column, value); };
    const QString key = textIn(columns, row, u"id");
    if (!table.version.isEmpty() && integer(table.version) > 0) {
        const auto here = m_versions.find(view->changeAt(integer(table.version)));
        set(table.version, here == m_versions.end() ? qint64(0) : here->second);
    }
    if (table.serial == TakenTable::Serial::Oldest) {
        set(u"serial", qint64(0));
    } else if (table.serial == TakenTable::Serial::Next) {
        ASSIGN_OR_RETURN(const qint64 serial, next(table.name, u"serial"_s));
        set(u"serial", serial);
    }
    if (table.name == u"types") {
        const Cell name = cellIn(columns, row, u"name");
        ASSIGN_OR_RETURN(const bool taken, isThere(u"SELECT 1 FROM types WHERE name = ?"_s, {name}));
        if (taken)
            set(u"name", textIn(columns, row, u"name") + u' ' + key);
    } else if (table.name == u"library_changes") {
        set(u"version", m_versions.at(key));
    } else if (table.name == u"type_versions") {
        ASSIGN_OR_RETURN(
            const qint64 version,
            number(u"SELECT COALESCE(MAX(version), 0) + 1 FROM type_versions WHERE type_id = ?"_s,
                   {cellIn(columns, row, u"type_id")}));
        set(u"version", version);
    } else if (table.name == u"type_states") {
        const auto recipe =
            view->recipes.find({textIn(columns, row, u"type_id"), integer(u"recipe_version")});
        if (recipe != view->recipes.end()) {
            ASSIGN_OR_RETURN(const qint64 version,
                             number(u"SELECT COALESCE(MAX(version), 0) FROM type_versions WHERE id = ?"_s,
                                    {recipe->second}));
            set(u"recipe_version", version);
        }
    } else if (table.name == u"estimates") {
        const Cell grasp = cellIn(columns, row, u"grasp_id");
        ASSIGN_OR_RETURN(const bool taken,
                         isThere(u"SELECT 1 FROM estimates WHERE grasp_id = ? AND rank = ?"_s,
                                 {grasp, cellIn(columns, row, u"rank")}));
        if (taken) {
            ASSIGN_OR_RETURN(const qint64 rank,
                             number(u"SELECT MAX(rank) + 1 FROM estimates WHERE grasp_id = ?"_s, {grasp}));
            set(u"rank", rank);
        }
    } else if (table.name == u"inspections") {
        ASSIGN_OR_RETURN(const qint64 number, next(table.name, u"number"_s));
        set(u"number", number);
    } else if (table.name == u"calibrations" && integer(u"certificate_number") > 0) {
        // Two libraries of one station may have counted the same; which it was stands beside the row.
        ASSIGN_OR_RETURN(
            const bool taken,
            isThere(u"SELECT 1 FROM calibrations WHERE station = ? AND certificate_number = ?"_s,
                    {cellIn(columns, row, u"station"), cellIn(columns, row, u"certificate_number")}));
        if (taken)
            set(u"certificate_number", qint64(0));
    }
    return {};
}

Expected<void> RowTaker::insert(const TakenTable& table, const Columns& columns, const TableRows::Row& row)
{
    QStringList names, places;
    for (const Column& column : columns) {
        names += column.name;
        places += u"?"_s;
    }
    Statement statement(m_target, takingRows(),
                        u"INSERT INTO %1 (%2) VALUES (%3) ON CONFLICT DO NOTHING"_s.arg(
                            table.name, names.join(u", "_s), places.join(u", "_s)));
    for (const Cell& cell : row)
        bindCell(statement, cell);
    return statement.run();
}

Expected<bool> RowTaker::isThere(const QString& sql, const std::vector<Cell>& values)
{
    return number(sql, values).map([](qint64 found) { return found != 0; });
}

Expected<qint64> RowTaker::number(const QString& sql, const std::vector<Cell>& values)
{
    Statement query(m_target, takingRows(), sql);
    for (const Cell& value : values)
        bindCell(query, value);
    return numberOf(query);
}

Expected<qint64> RowTaker::next(const QString& table, const QString& column)
{
    auto found = m_next.find(table);
    if (found == m_next.end()) {
        ASSIGN_OR_RETURN(const qint64 last,
                         number(u"SELECT COALESCE(MAX(%2), 0) FROM %1"_s.arg(table, column)));
        found = m_next.emplace(table, last).first;
    }
    return ++found->second;
}

} // namespace gripscope
