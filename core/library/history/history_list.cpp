// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/words.h"
#include "core/library/history/history_view.h"
#include "core/library/sql/rows.h"

#include <algorithm>

namespace gripscope::history_list {

using namespace Qt::StringLiterals;

namespace {

constexpr auto mostCollected = HistoryList::mostCollected;

QString readingHistory()
{
    return Words::tr("read the history");
}

/// The same squeezes, ordered by nothing that needs a join.
HistoryQuery byTime(HistoryQuery query)
{
    query.order = HistoryColumn::Time;
    return query;
}

HistoryMark takeMark(Statement& row)
{
    HistoryMark mark;
    mark.time = row.takeText();
    mark.key = row.takeText();
    return mark;
}

Expected<HistoryMark> newestSqueeze(Database& database)
{
    HistoryMark newest;
    Statement query(database, readingHistory(),
                    u"SELECT g.recorded_utc, g.id FROM grasps g "_s + HistorySelection::orderByTime(true) +
                        u"LIMIT 1"_s);
    RETURN_IF_ERROR(query.forEach([&](Statement& row) { newest = takeMark(row); }));
    return newest;
}

Expected<qint64> lastStored(Database& database)
{
    Statement query(database, readingHistory(),
                    u"SELECT COALESCE(MAX(%1), 0) FROM grasps"_s.arg(Database::orderOfInsertion()));
    return numberOf(query);
}

/// What a query finds, up to one more than a list collects.
struct Collected {
    struct Row {
        QString key, time;
    };
    std::vector<Row> rows;
    HistoryCounts counts;
    qint64 named = 0; ///< see HistorySelection::named()
};

/// Those that come first by time, and of them their order: a list by time in its own direction, another one
/// the newest, by number upwards the oldest.
Expected<Collected> collect(Database& database, const HistoryList& list, HistorySelection::TextBy textBy)
{
    const HistoryQuery& query = list.query;
    HistorySelection selection(query, HistorySelection::Inspections, textBy);
    selection.onlyOf(list);
    const bool byNumber = query.order == HistoryColumn::Number;
    const bool backwards = query.descending || (query.order != HistoryColumn::Time && !byNumber);
    QString sql =
        u"SELECT g.id AS id, g.recorded_utc AS time, %1, %2 AS named, %3 AS place "_s.arg(
            history_view::alikeColumns(historyIsVoidedSql()), selection.named(), selection.ordered()) +
        selection.fromWhere() + HistorySelection::orderByTime(backwards) +
        u"LIMIT %1"_s.arg(mostCollected + 1);
    if (query.order != HistoryColumn::Time)
        sql = u"SELECT * FROM (%1) AS found ORDER BY place IS NULL, place %2, time DESC, id DESC"_s.arg(
            sql, query.descending ? u"DESC"_s : u"ASC"_s);
    Statement statement(database, readingHistory(), selection.with() + sql);
    selection.bind(statement);
    Collected found;
    RETURN_IF_ERROR(statement.forEach([&](Statement& row) {
        Collected::Row one;
        one.key = row.takeText();
        one.time = row.takeText();
        found.rows.push_back(std::move(one));
        found.counts += history_view::takeAlike(row, 1);
        found.named = row.takeInteger();
    }));
    return found;
}

/// A text that is in few squeezes is found by indexes, one that is in many on the way.
Expected<Collected> collect(Database& database, const HistoryList& list)
{
    using TextBy = HistorySelection::TextBy;
    if (list.query.text.isEmpty())
        return collect(database, list, TextBy::Rows);
    ASSIGN_OR_RETURN(Collected found, collect(database, list, TextBy::Keys));
    HistoryQuery textAlone;
    textAlone.text = list.query.text;
    textAlone.order = list.query.order;
    textAlone.descending = list.query.descending;
    const bool tells = !found.rows.empty() || list.query == textAlone; // how many were named
    if (tells && found.named <= HistorySelection::mostNamed)
        return found;
    return collect(database, list, TextBy::Rows);
}

/// Of one more than the list takes, the one that comes last by time goes.
void dropLast(std::vector<Collected::Row>& rows, bool backwards)
{
    const auto earlier = [](const Collected::Row& a, const Collected::Row& b) {
        return a.time != b.time ? a.time < b.time : a.key < b.key;
    };
    rows.erase(backwards ? std::min_element(rows.begin(), rows.end(), earlier)
                         : std::max_element(rows.begin(), rows.end(), earlier));
}

/// Where the next stretch ends; nothing where it is the last.
Expected<std::optional<HistoryMark>> endOfStretch(Database& database, const HistoryList& list,
                                                  const HistoryMark& begin)
{
    HistoryQuery period;
    period.from = list.query.from;
    period.to = list.query.to;
    HistorySelection selection(period);
    selection.onlyOf(list);
    selection.onlyBehind(begin, list.backwards());
    Statement statement(database, readingHistory(),
                        u"SELECT g.recorded_utc, g.id "_s + selection.fromWhere() +
                            HistorySelection::orderByTime(list.backwards()) + u"LIMIT 1 OFFSET ?"_s);
    selection.bind(statement);
    statement.bind((list.query.everything() ? HistoryList::openStretch : HistoryList::stretch) - 1);
    std::optional<HistoryMark> end;
    RETURN_IF_ERROR(statement.forEach([&](Statement& row) { end = takeMark(row); }));
    return end;
}

} // namespace

Expected<HistoryList> find(Database& database, const HistoryQuery& query)
{
    HistoryList list;
    list.query = query;
    ASSIGN_OR_RETURN(const auto oneState, ReadTransaction::begin(database, readingHistory()));
    ASSIGN_OR_RETURN(list.stored, lastStored(database));
    ASSIGN_OR_RETURN(list.newest, newestSqueeze(database));
    const bool known = history_view::talliesKnow(query);
    if (known) {
        ASSIGN_OR_RETURN(list.counts, history_view::counts(database, query));
        list.walked = query.order == HistoryColumn::Time && list.counts.total() > qint64(mostCollected);
        list.rows = list.counts.total();
        list.through = !list.walked;
        if (list.walked)
            return list;
    }
    ASSIGN_OR_RETURN(Collected found, collect(database, list));
    const bool more = found.rows.size() > mostCollected;
    if (!known || !more)
        list.counts = found.counts;
    list.counted = known || !more;
    list.through = list.counted;
    list.walked = more && query.order == HistoryColumn::Time;
    list.cut = more && !list.walked;
    list.rows = qint64(std::min(found.rows.size(), mostCollected));
    if (list.cut)
        dropLast(found.rows, query.order != HistoryColumn::Number || query.descending);
    if (!list.walked)
        for (const Collected::Row& row : found.rows)
            list.keys.append(row.key);
    return list;
}

Expected<void> goOn(Database& database, HistoryList& list)
{
    if (list.through)
        return {};
    const HistoryMark begin = list.marks.empty() ? HistoryMark{} : list.marks.back();
    ASSIGN_OR_RETURN(const std::optional<HistoryMark> end, endOfStretch(database, list, begin));
    if (list.walked && list.query.everything()) { // each is found, and how many there are is known
        list.through = !end;
        if (end) {
            list.marks.push_back(*end);
            list.marks.back().row = begin.row + HistoryList::openStretch;
        }
        return {};
    }
    HistorySelection selection(byTime(list.query), HistorySelection::Inspections);
    selection.onlyOf(list);
    selection.onlyBehind(begin, list.backwards());
    if (end)
        selection.onlyUpTo(*end, list.backwards());
    ASSIGN_OR_RETURN(const HistoryCounts counts, history_view::countsOf(database, selection));
    list.passed += counts;
    list.through = !end;
    if (end) {
        list.marks.push_back(*end);
        list.marks.back().row = list.passed.total();
    }
    if (list.counted) // by the tallies: the way was gone for the marks
        return {};
    if (list.through || list.passed.total() > list.counts.total())
        list.counts = list.passed;
    list.counted = list.through;
    if (list.walked)
        list.rows = list.through ? list.passed.total() : std::max(list.rows, list.passed.total());
    return {};
}

Expected<void> goThrough(Database& database, HistoryList& list)
{
    while (!list.through)
        RETURN_IF_ERROR(goOn(database, list));
    return {};
}

Expected<std::vector<QString>> keys(Database& database, const HistoryList& list, qint64 first, qint64 count)
{
    first = std::max<qint64>(0, first);
    if (!list.walked)
        return list.keys.part(std::size_t(first), std::size_t(std::max<qint64>(0, count)));
    count = std::min(count, list.rows - first);
    if (count <= 0)
        return std::vector<QString>{};
    HistoryMark begin;
    for (const HistoryMark& mark : list.marks)
        if (mark.row <= first)
            begin = mark;
    // From the end where that is nearer.
    const qint64 behind = list.rows - first - count;
    const bool fromEnd = list.counted && behind < first - begin.row;
    HistorySelection selection(byTime(list.query));
    selection.onlyOf(list);
    if (!fromEnd)
        selection.onlyBehind(begin, list.backwards());
    Statement statement(database, readingHistory(),
                        u"SELECT g.id "_s + selection.fromWhere() +
                            HistorySelection::orderByTime(list.backwards() != fromEnd) +
                            u"LIMIT ? OFFSET ?"_s);
    selection.bind(statement);
    statement.bind(count).bind(fromEnd ? behind : first - begin.row);
    std::vector<QString> keys;
    RETURN_IF_ERROR(statement.forEach([&](Statement& row) { keys.push_back(row.takeText()); }));
    if (fromEnd)
        std::reverse(keys.begin(), keys.end());
    return keys;
}

Expected<std::optional<qint64>> rowOf(Database& database, const HistoryList& list, const QString& key)
{
    if (!list.walked) {
        const std::optional<std::size_t> place = list.keys.find(key);
        return place ? std::optional(qint64(*place)) : std::nullopt;
    }
    HistoryMark wanted;
    Statement there(database, readingHistory(),
                    u"SELECT g.recorded_utc, g.id FROM grasps g WHERE g.id = ?"_s);
    there.bind(key);
    RETURN_IF_ERROR(there.forEach([&](Statement& row) { wanted = takeMark(row); }));
    const auto place = [](const HistoryMark& mark) { return std::pair(mark.time, mark.key); };
    if (wanted.key.isEmpty() || place(wanted) > place(list.newest))
        return std::nullopt;
    HistoryMark begin;
    for (const HistoryMark& mark : list.marks)
        if (list.backwards() ? place(mark) > place(wanted) : place(mark) < place(wanted))
            begin = mark;
    HistorySelection selection(byTime(list.query));
    selection.onlyOf(list);
    selection.onlyBehind(begin, list.backwards());
    selection.onlyUpTo(wanted, list.backwards());
    Statement statement(database, readingHistory(),
                        u"SELECT COUNT(*), COALESCE(MAX(CASE WHEN g.id = ? THEN 1 ELSE 0 END), 0) "_s +
                            selection.fromWhere());
    statement.bind(key);
    selection.bind(statement);
    std::optional<qint64> row;
    RETURN_IF_ERROR(statement.forEach([&](Statement& counted) {
        const qint64 upTo = counted.takeInteger();
        if (counted.takeInteger() != 0) // it is found
            row = begin.row + upTo - 1;
    }));
    return row;
}

} // namespace gripscope::history_list
