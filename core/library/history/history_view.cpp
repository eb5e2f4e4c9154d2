// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/history/history_view.h"

#include "core/base/words.h"
#include "core/library/history/history_fields.h"
#include "core/library/tables/estimate_tables.h"
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

QString entryColumns()
{
    QStringList columns;
    for (const HistoryField& field : historyFields())
        if (field.take != nullptr)
            columns << field.sql;
    return u"SELECT "_s + columns.join(u", "_s) + u' ';
}

/// One row of those that points() asks for; a squeeze without m, b and k is counted only.
void takePoint(Statement& row, HistoryPoints& points, QHash<QString, int>& types)
{
    HistoryPoint point;
    const QString id = row.takeText();
    point.time_ms = row.takeUtc().toMSecsSinceEpoch();
    ++points.operators[row.takeText()];
    const QString device = row.takeText();
    const QString serial = row.takeText();
    ++points.serials[serial];
    points.devices[serial] = device;
    const QString verdict = row.takeText();
    const QString expected = row.takeText();
    const QString type = row.takeText();
    if (const auto kind = verdictKindFromString(verdict))
        point.outcome = inspectionOutcome(*kind, type, expected);
    const auto parameters = estimate_table::takeParameters(row);
    if (!parameters)
        return;
    point.parameters = *parameters;
    if (!type.isEmpty()) {
        if (!types.contains(type)) {
            types.insert(type, int(points.types.size()));
            points.types.append(type);
        }
        point.type = types.value(type);
    }
    if (const auto errors = estimate_table::takeStandardErrors(row))
        point.standardErrors = {(*errors)(0), (*errors)(1), (*errors)(2)};
    const QString force = row.takeText();
    const std::optional<double> factor = siFactor(force, row.takeText());
    points.si = points.si && factor.has_value();
    const double scale = factor.value_or(1);
    for (double MassDampingStiffness::*member :
         {&MassDampingStiffness::m, &MassDampingStiffness::b, &MassDampingStiffness::k}) {
        point.parameters.*member *= scale;
        point.standardErrors.*member *= scale;
    }
    points.keys.append(id);
    points.points.push_back(point);
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
    std::vector<HistoryEntry> entries;
    for (std::optional<HistoryEntry>& entry : found)
        if (entry)
            entries.push_back(std::move(*entry));
    return entries;
}

Expected<HistoryCounts> counts(Database& database, const HistoryQuery& query)
{
    HistoryCounts counts;
    HistoryQuery unordered = query;
    unordered.order = HistoryColumn::Time;
    const HistorySelection selection(unordered, HistorySelection::Inspections);
    Statement statement(database, readingHistory(),
                        u"SELECT CASE WHEN g.type_id IS NULL THEN 0 ELSE 1 END, i.verdict, i.expected_type, "
                        "i.type_name, COUNT(*) "_s +
                            selection.fromWhere() + u"GROUP BY 1, 2, 3, 4"_s);
    selection.bind(statement);
    auto done = statement.forEach([&](Statement& row) {
        const bool enrolled = row.takeInteger() != 0;
        const auto verdict = verdictKindFromString(row.takeText());
        const QString expected = row.takeText();
        const QString type = row.takeText();
        const qint64 count = row.takeInteger();
        (enrolled ? counts.enrolled : counts.inspections) += count;
        if (!verdict)
            return;
        switch (inspectionOutcome(*verdict, type, expected)) {
        case InspectionOutcome::AsExpected:
            counts.asExpected += count;
            break;
        case InspectionOutcome::OtherType:
            counts.otherType += count;
            break;
        case InspectionOutcome::Unknown:
            counts.unknown += count;
            break;
        case InspectionOutcome::Inconclusive:
            counts.inconclusive += count;
            break;
        case InspectionOutcome::NotValid:
            counts.notValid += count;
            break;
        }
    });
    if (!done)
        return tl::unexpected(done.error());
    return counts;
}

Expected<HistoryPoints> points(Database& database, HistoryQuery query)
{
    query.order = HistoryColumn::Time;
    query.descending = false;
    HistoryPoints points;
    QHash<QString, int> types;
    const HistorySelection selection(query, HistorySelection::Inspections | HistorySelection::Types |
                                                HistorySelection::Estimates);
    Statement statement(
        database, readingHistory(),
        u"SELECT g.id, g.recorded_utc, g.operator_name, g.device_name, g.device_serial, "
        "COALESCE(i.verdict, ''), COALESCE(i.expected_type, ''), %1, e.m, e.b, e.k, e.var_m, e.var_b, "
        "e.var_k, g.force_unit, g.position_unit "_s.arg(historyTypeSql()) +
            selection.fromWhere() + selection.orderBy());
    selection.bind(statement);
    auto done = statement.forEach([&](Statement& row) { takePoint(row, points, types); });
    if (!done)
        return tl::unexpected(done.error());
    sortTypes(points);
    return points;
}

Expected<HistoryChoices> choices(Database& database)
{
    HistoryChoices choices;
    const std::pair<QString, QStringList HistoryChoices::*> lists[] = {
        {u"SELECT DISTINCT type_name FROM inspections UNION SELECT name FROM type_states WHERE status <> 'gone'"_s,
         &HistoryChoices::types},
        {u"SELECT DISTINCT expected_type FROM inspections"_s, &HistoryChoices::expected},
        {u"SELECT DISTINCT operator_name FROM grasps"_s, &HistoryChoices::operators},
        {u"SELECT DISTINCT %1 FROM grasps g"_s.arg(historyDeviceSql()), &HistoryChoices::devices},
        {u"SELECT DISTINCT name FROM batches"_s, &HistoryChoices::batches}};
    for (const auto& [sql, list] : lists) {
        ASSIGN_OR_RETURN(auto values, column(database, sql));
        choices.*list = std::move(values);
    }
    return choices;
}

} // namespace gripscope::history_view
