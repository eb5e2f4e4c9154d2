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

constexpr std::size_t rowsOfStretch = 200;

/// Rows by which types and enrolled squeezes become other than they were.
bool isChange(const QString& table)
{
    return table == u"library_changes" || table == u"type_states" || table == u"types" ||
           table == u"placements";
}

/// How a row is there, where it differs from the row here; nothing where it does not, and no number is its
/// own.
std::optional<MergedRow> keptOf(const TakenTable& table, const NewLeaf& leaf,
                                const std::vector<Column>& columns, const TableRows::Row& there,
                                const TableRows::Row& here)
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
    return merged;
}

MergedRow forTheRecord(const TakenTable& table, const NewLeaf& leaf, const std::vector<Column>& columns,
                       const TableRows::Row& there)
{
    MergedRow merged;
    merged.library = leaf.library;
    merged.table = table.ledgered().code;
    merged.key = keyText(leaf.leaf.key);
    merged.number = table.number.isEmpty() ? 0 : integerIn(columns, there, table.number);
    merged.whole = true;
    merged.content = merged_rows::contentOf(columns, there);
    return merged;
}

} // namespace

qint64 TakenRows::sum() const
{
    qint64 sum = 0;
    for (const auto& [table, rows] : byTable)
        sum += rows;
    return sum;
}

RowTaker::RowTaker(Database& source, const QString& sourceId, Database& target)
    : m_source(source), m_target(target), m_there(source, sourceId), m_views(source, sourceId)
{
}

Expected<TableRows::Row> RowTaker::rowThere(const LedgeredTable& table, const NewLeaf& leaf)
{
    ASSIGN_OR_RETURN(const auto columns, m_there.columns(table));
    ASSIGN_OR_RETURN(auto view, m_there.rowIn(leaf.library, table, leaf.leaf.key));
    if (view && (!m_hasLedger || rowDigest(*columns, view->row) == leaf.leaf.digest))
        return std::move(view->row);
    return failure(
        ErrorCode::StorageCorrupt,
        {m_source.file(),
         Words::tr("row %2 of %1 is not what its ledger says").arg(table.name, keyText(leaf.leaf.key))});
}

Expected<void> RowTaker::giveVersions(const std::vector<NewLeaf>& changes)
{
    if (std::ranges::none_of(changes, &NewLeaf::madeThere))
        return {};
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
    // What is in the order of its rows here, or told from them by its name, is looked up row by row.
    const bool oneByOne =
        table.name == u"types" || table.name == u"type_versions" || table.name == u"calibrations";
    const std::size_t stretch = oneByOne ? 1 : rowsOfStretch;
    for (std::size_t first = 0; first < leaves.size(); first += stretch)
        RETURN_IF_ERROR(
            takeStretch(table, std::span(leaves).subspan(first, std::min(stretch, leaves.size() - first))));
    return {};
}

Expected<bool> RowTaker::followsOnly(const TakenTable& table, const QString& library, const Columns& columns,
                                     const TableRows::Row& row)
{
    if (table.name == u"library_changes")
        return textIn(columns, row, u"kind") == toString(ChangeKind::Meeting);
    if (table.version != u"version")
        return false;
    ASSIGN_OR_RETURN(const LibraryView* view, m_views.of(library));
    return view->meetings.contains(integerIn(columns, row, u"version"));
}

Expected<std::vector<RowTaker::Arrival>>
RowTaker::arrivalsOf(const TakenTable& table, std::span<const NewLeaf> leaves, std::vector<MergedRow>& kept)
{
    ASSIGN_OR_RETURN(const auto columns, m_there.columns(table.ledgered()));
    std::vector<Arrival> arrivals;
    for (const NewLeaf& leaf : leaves) {
        ASSIGN_OR_RETURN(TableRows::Row there, rowThere(table.ledgered(), leaf));
        ASSIGN_OR_RETURN(const bool follows, followsOnly(table, leaf.library, *columns, there));
        if (table.kind != TakenTable::Kind::ForTheRecord && !follows)
            arrivals.push_back({leaf, std::move(there)});
        else
            kept.push_back(forTheRecord(table, leaf, *columns, there));
    }
    return arrivals;
}

Expected<void> RowTaker::takeStretch(const TakenTable& table, std::span<const NewLeaf> leaves)
{
    ASSIGN_OR_RETURN(const auto columns, m_there.columns(table.ledgered()));
    std::vector<MergedRow> kept;
    ASSIGN_OR_RETURN(std::vector<Arrival> arrivals, arrivalsOf(table, leaves, kept));
    RETURN_IF_ERROR(bringIn(table, *columns, arrivals));
    for (const Arrival& arrival : arrivals) {
        if (!arrival.here)
            kept.push_back(forTheRecord(table, arrival.leaf, *columns, arrival.there));
        else if (auto row = keptOf(table, arrival.leaf, *columns, arrival.there, *arrival.here))
            kept.push_back(std::move(*row));
    }
    m_taken.forTheRecord += std::ranges::count_if(kept, &MergedRow::whole);
    return m_hasLedger ? merged_rows::insert(m_target, kept) : Expected<void>();
}

Expected<void> RowTaker::bringIn(const TakenTable& table, const Columns& columns,
                                 std::vector<Arrival>& arrivals)
{
    std::vector<Cell> keys;
    keys.reserve(arrivals.size());
    for (const Arrival& arrival : arrivals)
        keys.push_back(arrival.leaf.leaf.key);
    ASSIGN_OR_RETURN(TableRows rows, TableRows::of(m_target, table.name, table.ledgered().key));
    ASSIGN_OR_RETURN(auto here, rows.withKeys(keys));
    std::vector<TableRows::Row> news;
    std::set<Cell> newKeys;
    for (const Arrival& arrival : arrivals) {
        const Cell& key = arrival.leaf.leaf.key;
        if (here.contains(key)) // or another library brought it in this same stretch
            continue;
        TableRows::Row adapted = arrival.there;
        RETURN_IF_ERROR(adapt(table, arrival.leaf.library, columns, adapted));
        news.push_back(adapted);
        newKeys.insert(key);
        here[key] = std::move(adapted);
    }
    ASSIGN_OR_RETURN(const auto inserted, rows.insert(news, takingRows()));
    if (table.name == u"grasps")
        for (const Cell& key : inserted)
            m_newSqueezes.insert(keyText(key));
    if (!inserted.empty()) {
        m_taken.byTable[table.name] += static_cast<qint64>(inserted.size());
        m_taken.hasChanges = m_taken.hasChanges || isChange(table.name);
    }
    for (Arrival& arrival : arrivals) {
        const Cell& key = arrival.leaf.leaf.key;
        if (!newKeys.contains(key) || inserted.contains(key)) // else, such as two ends of one batch
            arrival.here = here.at(key);
    }
    return {};
}

Expected<qint64> RowTaker::versionHere(const QString& change)
{
    if (change.isEmpty())
        return 0;
    auto known = m_versions.find(change);
    if (known == m_versions.end()) {
        ASSIGN_OR_RETURN(const qint64 version,
                         number(u"SELECT version FROM library_changes WHERE id = ?"_s, {change}));
        known = m_versions.emplace(change, version).first;
    }
    return known->second;
}

Expected<void> RowTaker::adapt(const TakenTable& table, const QString& library, const Columns& columns,
                               TableRows::Row& row)
{
    ASSIGN_OR_RETURN(const LibraryView* view, m_views.of(library));
    const auto set = [&](QStringView column, const Cell& value) { setCell(columns, row, column, value); };
    if (table.name == u"library_changes") {
        ASSIGN_OR_RETURN(const qint64 version, versionHere(textIn(columns, row, u"id")));
        if (version == 0)
            return failure(
                ErrorCode::StorageOpen,
                {m_target.file(),
                 Words::tr("a change that %1 has from here is no longer here: an older copy was put "
                           "back. Put back the newest copy there is")
                     .arg(m_source.file())});
        set(u"version", version);
    } else if (!table.version.isEmpty() && integerIn(columns, row, table.version) > 0) {
        ASSIGN_OR_RETURN(const qint64 version,
                         versionHere(view->changeAt(integerIn(columns, row, table.version))));
        set(table.version, version);
    }
    if (table.name == u"inspections") {
        ASSIGN_OR_RETURN(const qint64 number, next(table.name, u"number"_s));
        set(u"number", number);
    } else if (table.name == u"estimates") {
        return adaptRank(columns, row);
    } else if (table.name == u"calibrations" && integerIn(columns, row, u"certificate_number") > 0) {
        // Two libraries of one station may have counted the same; which it was stands beside the row.
        ASSIGN_OR_RETURN(
            const bool taken,
            isThere(u"SELECT 1 FROM calibrations WHERE station = ? AND certificate_number = ?"_s,
                    {cellIn(columns, row, u"station"), cellIn(columns, row, u"certificate_number")}));
        if (taken)
            set(u"certificate_number", qint64(0));
    }
    return adaptType(table, *view, columns, row);
}

Expected<void> RowTaker::adaptType(const TakenTable& table, const LibraryView& view, const Columns& columns,
                                   TableRows::Row& row)
{
    if (table.name == u"types") {
        ASSIGN_OR_RETURN(const bool taken,
                         isThere(u"SELECT 1 FROM types WHERE name = ?"_s, {cellIn(columns, row, u"name")}));
        if (taken)
            setCell(columns, row, u"name",
                    textIn(columns, row, u"name") + u' ' + textIn(columns, row, u"id"));
    } else if (table.name == u"type_versions") {
        ASSIGN_OR_RETURN(
            const qint64 version,
            number(u"SELECT COALESCE(MAX(version), 0) + 1 FROM type_versions WHERE type_id = ?"_s,
                   {cellIn(columns, row, u"type_id")}));
        setCell(columns, row, u"version", version);
    } else if (table.name == u"type_states") {
        const auto recipe =
            view.recipes.find({textIn(columns, row, u"type_id"), integerIn(columns, row, u"recipe_version")});
        if (recipe == view.recipes.end())
            return {};
        ASSIGN_OR_RETURN(
            const qint64 version,
            number(u"SELECT COALESCE(MAX(version), 0) FROM type_versions WHERE id = ?"_s, {recipe->second}));
        setCell(columns, row, u"recipe_version", version);
    }
    return {};
}

Expected<void> RowTaker::adaptRank(const Columns& columns, TableRows::Row& row)
{
    const QString grasp = textIn(columns, row, u"grasp_id");
    auto ranks = m_ranks.find(grasp);
    if (ranks == m_ranks.end()) {
        ranks = m_ranks.emplace(grasp, std::set<qint64>()).first;
        // A squeeze that has just come in can have none here.
        if (!m_newSqueezes.contains(grasp)) {
            Statement query(m_target, takingRows(), u"SELECT rank FROM estimates WHERE grasp_id = ?"_s);
            RETURN_IF_ERROR(query.bind(grasp).forEach(
                [&](Statement& found) { ranks->second.insert(found.takeInteger()); }));
        }
    }
    const qint64 rank = integerIn(columns, row, u"rank");
    const qint64 here = ranks->second.contains(rank) ? *ranks->second.rbegin() + 1 : rank;
    ranks->second.insert(here);
    setCell(columns, row, u"rank", here);
    return {};
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
