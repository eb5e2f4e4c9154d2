// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/history/history_view.h"

#include "core/base/words.h"
#include "core/library/history/history_fields.h"
#include "core/library/history/history_text.h"
#include "core/library/tables/audit_table.h"
#include "core/library/tables/estimate_tables.h"
#include "core/library/tables/inspection_tables.h"
#include "core/library/tables/type_tables.h"
#include "core/signal/recording/units.h"

#include <QHash>

#include <algorithm>
#include <cmath>

namespace gripscope::history_view {

using namespace Qt::StringLiterals;

namespace {

QString readingHistory()
{
    return Words::tr("read the history");
}

/// One row of `entryColumns`.
HistoryEntry takeEntry(Statement& row)
{
    HistoryEntry entry;
    for (const HistoryField& field : historyFields())
        if (field.take != nullptr)
            field.take(row, entry);
    return entry;
}

/// The squeeze was there when the clock was set back over its time.
bool concerns(const ClockStep& step, const HistoryEntry& entry)
{
    if (!step.covers(entry.station, entry.time))
        return false;
    return entry.number > 0 ? entry.number <= step.lastInspection.value_or(entry.number)
                            : !step.lastVersion || entry.libraryVersion.value_or(0) <= *step.lastVersion;
}

QString entryColumns()
{
    QStringList columns;
    for (const HistoryField& field : historyFields())
        if (field.take != nullptr)
            columns << field.sql;
    return u"SELECT "_s + columns.join(u", "_s) + u' ';
}

constexpr int pointNeeds =
    HistorySelection::Inspections | HistorySelection::Types | HistorySelection::Estimates;

struct FoundPoint {
    QString key, type;
    HistoryPoint point;
    bool si = true;
};

/// Of a squeeze; in SI where its units are known.
QString pointColumns()
{
    return u"SELECT g.id, g.recorded_utc, COALESCE(%3, ''), COALESCE(i.expected_type, ''), %1, %2, "
           "e.m, e.b, e.k, e.var_m, e.var_b, e.var_k, g.force_unit, g.position_unit "_s.arg(
               historyTypeSql(), historyValiditySql(), inspection_table::judgedSql(u"i."_s));
}

/// Nothing for a squeeze without m, b and k.
std::optional<FoundPoint> takePoint(Statement& row)
{
    FoundPoint found;
    HistoryPoint& point = found.point;
    found.key = row.takeText();
    point.time_ms = row.takeUtc().toMSecsSinceEpoch();
    const std::optional<PartJudged> judged = partJudgedFromString(row.takeText());
    const QString expected = row.takeText();
    found.type = row.takeText();
    if (judged)
        point.outcome = inspectionOutcome(*judged, found.type, expected);
    point.validity = validityVerdictFromString(row.takeText());
    const auto parameters = estimate_table::takeParameters(row);
    if (!parameters)
        return {};
    point.parameters = *parameters;
    if (const auto errors = estimate_table::takeStandardErrors(row))
        point.standardErrors = {(*errors)(0), (*errors)(1), (*errors)(2)};
    const QString force = row.takeText();
    const std::optional<double> factor = siFactor(force, row.takeText());
    found.si = factor.has_value();
    const double scale = factor.value_or(1);
    for (double MassDampingStiffness::*member :
         {&MassDampingStiffness::m, &MassDampingStiffness::b, &MassDampingStiffness::k}) {
        point.parameters.*member *= scale;
        point.standardErrors.*member *= scale;
    }
    return found;
}

void sortTypes(HistoryPoints& points)
{
    QStringList sorted = points.types;
    sorted.sort(Qt::CaseInsensitive);
    for (HistoryPoint& point : points.points)
        if (point.type >= 0)
            point.type = int(sorted.indexOf(points.types[point.type]));
    points.types = sorted;
}

/// In order of time, each with its type.
HistoryPoints together(std::vector<FoundPoint> found)
{
    std::sort(found.begin(), found.end(), [](const FoundPoint& a, const FoundPoint& b) {
        return a.point.time_ms != b.point.time_ms ? a.point.time_ms < b.point.time_ms : a.key < b.key;
    });
    HistoryPoints points;
    QHash<QString, int> types;
    for (FoundPoint& one : found) {
        if (!one.type.isEmpty()) {
            if (!types.contains(one.type)) {
                types.insert(one.type, int(points.types.size()));
                points.types.append(one.type);
            }
            one.point.type = types.value(one.type);
        }
        points.si = points.si && one.si;
        points.keys.append(one.key);
        points.points.push_back(one.point);
    }
    sortTypes(points);
    return points;
}

Expected<QStringList> column(Database& database, const QString& sql)
{
    QStringList values;
    Statement query(database, readingHistory(), sql);
    auto done = query.forEach([&](Statement& row) {
        if (const QString value = row.takeText(); !value.isEmpty())
            values << value;
    });
    if (!done)
        return tl::unexpected(done.error());
    values.sort(Qt::CaseInsensitive);
    return values;
}

} // namespace

Expected<HistoryKeys> keys(Database& database, const HistoryQuery& query)
{
    HistoryKeys keys;
    const HistorySelection selection(query);
    Statement statement(database, readingHistory(),
                        u"SELECT g.id "_s + selection.fromWhere() + selection.orderBy());
    selection.bind(statement);
    auto done = statement.forEach([&](Statement& row) { keys.append(row.takeText()); });
    if (!done)
        return tl::unexpected(done.error());
    return keys;
}

Expected<std::vector<HistoryEntry>> entries(Database& database, const std::vector<QString>& graspIds)
{
    if (graspIds.empty())
        return std::vector<HistoryEntry>{};
    QStringList marks;
    QHash<QString, std::size_t> places;
    for (const QString& id : graspIds) {
        places.insert(id, places.size());
        marks << u"?"_s;
    }
    Statement statement(database, readingHistory(),
                        entryColumns() +
                            HistorySelection::from(HistorySelection::Batches | HistorySelection::Types |
                                                   HistorySelection::Estimates) +
                            u"WHERE g.id IN (%1)"_s.arg(marks.join(u',')));
    for (const QString& id : graspIds)
        statement.bind(id);
    std::vector<std::optional<HistoryEntry>> found(graspIds.size());
    auto done = statement.forEach([&](Statement& row) {
        HistoryEntry entry = takeEntry(row);
        found[places.value(entry.graspId)] = std::move(entry);
    });
    if (!done)
        return tl::unexpected(done.error());
    ASSIGN_OR_RETURN(const std::vector<ClockStep> steps, audit_table::clockSteps(database));
    std::vector<HistoryEntry> entries;
    for (std::optional<HistoryEntry>& entry : found)
        if (entry) {
            for (const ClockStep& step : steps)
                if (concerns(step, *entry))
                    entry->clockSetBack = step;
            entries.push_back(std::move(*entry));
        }
    return entries;
}

namespace {

/// Every name that a type has or had; one that several had goes to the last of them.
Expected<QHash<QString, int>> placesByName(Database& database, const QHash<QString, int>& places)
{
    QHash<QString, int> named;
    Statement statement(database, readingHistory(),
                        u"SELECT type_id, name FROM type_states ORDER BY version, status <> 'gone'"_s);
    auto done = statement.forEach([&](Statement& row) {
        const QString id = row.takeText();
        named.insert(row.takeText(), places.value(id));
    });
    if (!done)
        return tl::unexpected(done.error());
    return named;
}

/// With the places of their types.
Expected<HistoryPoints> placed(Database& database, HistoryPoints points)
{
    ASSIGN_OR_RETURN(const auto places, type_table::places(database));
    ASSIGN_OR_RETURN(const auto named, placesByName(database, places));
    auto next = int(places.size());
    for (const QString& type : points.types) {
        const auto known = named.constFind(type);
        points.places.push_back(known != named.constEnd() ? *known : next++);
    }
    return points;
}

Expected<void> readPoints(Statement& statement, std::vector<FoundPoint>& found)
{
    return statement.forEach([&](Statement& row) {
        if (std::optional<FoundPoint> point = takePoint(row))
            found.push_back(std::move(*point));
    });
}

/// Of the squeezes with these keys.
Expected<void> readPointsOf(Database& database, const std::vector<QString>& keys,
                            std::vector<FoundPoint>& found)
{
    HistorySelection selection({}, pointNeeds);
    selection.withoutVoided();
    Statement statement(
        database, readingHistory(),
        pointColumns() + selection.fromWhere() +
            u"AND g.id IN (%1)"_s.arg(QStringList(qsizetype(keys.size()), u"?"_s).join(u',')));
    for (const QString& key : keys)
        statement.bind(key);
    return readPoints(statement, found);
}

} // namespace

Expected<HistoryPoints> points(Database& database, const HistoryList& list)
{
    constexpr std::size_t keysAtOnce = 500;
    std::vector<FoundPoint> found;
    if (!list.walked && !list.cut) {
        for (std::size_t first = 0; first < list.keys.size(); first += keysAtOnce)
            RETURN_IF_ERROR(readPointsOf(database, list.keys.part(first, keysAtOnce), found));
        return placed(database, together(std::move(found)));
    }
    HistoryQuery query = list.query;
    query.order = HistoryColumn::Time;
    HistorySelection selection(query, pointNeeds);
    selection.withoutVoided();
    selection.onlyOf(list);
    const qint64 oneIn = std::max<qint64>(1, (list.counts.inspections + mostPoints - 1) / mostPoints);
    if (oneIn > 1)
        selection.onlyOneIn(oneIn);
    Statement statement(database, readingHistory(), pointColumns() + selection.fromWhere());
    selection.bind(statement);
    RETURN_IF_ERROR(readPoints(statement, found));
    HistoryPoints points = together(std::move(found));
    points.oneIn = oneIn;
    return placed(database, std::move(points));
}

namespace {

Expected<void> readRates(Database& database, const HistorySelection& selection, HistoryInForce& found)
{
    Statement statement(database, readingHistory(),
                        u"SELECT i.false_reject, i.wrong_type, i.stranger_accept, i.confidence, i.robust, "
                        "COUNT(*) "_s +
                            selection.fromWhere() + u"GROUP BY 1, 2, 3, 4, 5 ORDER BY 6 DESC, 1, 2"_s);
    selection.bind(statement);
    return statement.forEach([&](Statement& row) {
        HeldTo held;
        for (std::optional<double>* rate :
             {&held.falseReject, &held.wrongType, &held.strangerAccept, &held.confidence})
            *rate = row.takeOptionalReal();
        if (const std::optional<qint64> robust = row.takeOptionalInteger())
            held.robust = *robust != 0;
        if (held.falseReject) // of an inspection
            found.rates.push_back({held, row.takeInteger()});
    });
}

Expected<void> readCalibrations(Database& database, const HistorySelection& selection, HistoryInForce& found)
{
    Statement statement(database, readingHistory(),
                        u"SELECT g.device_serial, g.force_calibration, g.position_calibration, COUNT(*) "_s +
                            selection.fromWhere() + u"GROUP BY 1, 2, 3"_s);
    selection.bind(statement);
    return statement.forEach([&](Statement& row) {
        HistoryInForce::Calibrations& gripper = found.calibrations[row.takeText()];
        const std::optional<QString> force = row.takeOptionalText();
        const std::optional<QString> position = row.takeOptionalText();
        const qint64 count = row.takeInteger();
        gripper.force[force] += count;
        gripper.position[position] += count;
    });
}

Expected<void> readVersions(Database& database, const HistorySelection& selection, HistoryInForce& found)
{
    Statement statement(database, readingHistory(),
                        u"SELECT i.program, MIN(i.library_version), MAX(i.library_version), "
                        "COUNT(i.id), COUNT(i.library_version) "_s +
                            selection.fromWhere() + u"GROUP BY 1"_s);
    selection.bind(statement);
    return statement.forEach([&](Statement& row) {
        const QString program = row.takeText();
        const std::optional<qint64> first = row.takeOptionalInteger();
        const std::optional<qint64> last = row.takeOptionalInteger();
        const qint64 inspections = row.takeInteger();
        found.withoutVersion += inspections - row.takeInteger();
        if (inspections > 0)
            found.programs[program] += inspections;
        if (first && last) {
            found.firstVersion = std::min(found.firstVersion.value_or(*first), *first);
            found.lastVersion = std::max(found.lastVersion.value_or(*last), *last);
        }
    });
}

Expected<void> readPeople(Database& database, HistorySelection selection, HistoryInForce& found)
{
    selection.withoutVoided();
    Statement statement(database, readingHistory(),
                        u"SELECT g.operator_name, g.device_serial, MAX(g.device_name), COUNT(*) "_s +
                            selection.fromWhere() + u"GROUP BY 1, 2"_s);
    selection.bind(statement);
    return statement.forEach([&](Statement& row) {
        const QString operatorName = row.takeText();
        const QString serial = row.takeText();
        found.devices[serial] = row.takeText();
        const qint64 count = row.takeInteger();
        found.operators[operatorName] += count;
        found.serials[serial] += count;
    });
}

} // namespace

Expected<HistoryInForce> inForce(Database& database, HistoryQuery query)
{
    query.order = HistoryColumn::Time;
    const HistorySelection selection(query, HistorySelection::Inspections);
    HistoryInForce found;
    RETURN_IF_ERROR(readRates(database, selection, found));
    RETURN_IF_ERROR(readCalibrations(database, selection, found));
    RETURN_IF_ERROR(readVersions(database, selection, found));
    RETURN_IF_ERROR(readPeople(database, selection, found));
    return found;
}

Expected<HistoryChoices> choices(Database& database)
{
    HistoryChoices choices;
    // Never by reading every row: the page asks each time it is shown.
    const std::pair<QString, QStringList HistoryChoices::*> lists[] = {
        {u"SELECT value FROM (%1) AS named UNION SELECT name FROM type_states WHERE status <> 'gone'"_s.arg(
             distinctSql(u"inspections"_s, u"type_name"_s)),
         &HistoryChoices::types},
        {distinctSql(u"inspections"_s, u"expected_type"_s), &HistoryChoices::expected},
        {distinctSql(u"grasps"_s, u"operator_name"_s), &HistoryChoices::operators},
        {distinctSql(u"grasps"_s, u"TRIM(device_name || ' ' || device_serial)"_s), &HistoryChoices::devices},
        {u"SELECT DISTINCT name FROM batches"_s, &HistoryChoices::batches}};
    for (const auto& [sql, list] : lists) {
        ASSIGN_OR_RETURN(auto values, column(database, sql));
        choices.*list = std::move(values);
    }
    return choices;
}

} // namespace gripscope::history_view
