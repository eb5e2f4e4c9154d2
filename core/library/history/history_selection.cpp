// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/history/history_fields.h"
#include "core/library/history/history_text.h"
#include "core/library/history/history_view.h"
#include "core/library/tables/grasp_table.h"
#include "core/library/tables/inspection_tables.h"
#include "core/signal/recording/units.h"

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

/// "CASE column WHEN 'mN' THEN 0.001 ... END": NULL for a unit that is not known.
QString factorSql(const QString& column, const QStringList& units,
                  std::optional<double> (*factor)(const QString&))
{
    QString sql = u"CASE "_s + column;
    for (const QString& unit : units)
        if (const std::optional<double> known = factor(unit))
            sql += u" WHEN '%1' THEN %2"_s.arg(unit, QString::number(*known, 'e', 16));
    return sql + u" END"_s;
}

} // namespace

QString historyTypeSql()
{
    return u"COALESCE(i.type_name, s.name, '')"_s;
}

QString historyOutcomeSql()
{
    return u"CASE i.verdict WHEN 'type' THEN CASE WHEN i.expected_type NOT IN ('', i.type_name) THEN 1 "
           u"WHEN i.conformity IN ('', 'conforms') THEN 0 WHEN i.conformity = 'does_not_conform' THEN 5 ELSE "
           u"3 END "
           u"WHEN 'unknown' THEN 2 WHEN 'inconclusive' THEN 3 WHEN 'invalid' THEN 4 END"_s;
}

QString historyValiditySql()
{
    return u"CASE WHEN i.id IS NULL THEN '' ELSE %1 END"_s.arg(inspection_table::validitySql());
}

QString historyDeviceSql()
{
    return u"TRIM(g.device_name || ' ' || g.device_serial)"_s;
}

QString historyProgramSql()
{
    return u"COALESCE(NULLIF(e.program, ''), i.program, '')"_s;
}

QString historyVersionSql()
{
    return u"COALESCE(i.library_version, NULLIF(g.library_version, 0))"_s;
}

QString historyIsVoidedSql()
{
    return u"CASE WHEN i.id IN (SELECT inspection_id FROM inspection_voids) THEN 1 ELSE 0 END"_s;
}

QString historyVoidedSql()
{
    return u"COALESCE((SELECT x.reason FROM inspection_voids x WHERE x.inspection_id = i.id), '')"_s;
}

QString historySiSql(const QString& column)
{
    static const QString factor =
        u"COALESCE(%1 / %2, 1)"_s.arg(factorSql(u"g.force_unit"_s, forceUnits(), newtonsPer),
                                      factorSql(u"g.position_unit"_s, positionUnits(), metresPer));
    return u"%1 * %2"_s.arg(column, factor);
}

HistorySelection::HistorySelection(const HistoryQuery& query, int needs, TextBy textBy)
    : m_query(query), m_needs(needs)
{
    m_needs |= factsOf(query.order).needs;
    if (query.kind)
        m_conditions << (*query.kind == SqueezeKind::Enrollment
                             ? u"g.type_id > ''"_s // not NULL, in a form that an index is used for
                             : u"g.type_id IS NULL"_s);
    if (query.from.isValid())
        addBound(m_lower, {{0, utcText(query.from), {}}, true, u"g.recorded_utc >= ?"_s});
    if (query.to.isValid())
        addBound(m_upper, {{0, utcText(query.to), {}}, false, u"g.recorded_utc < ?"_s});
    if (!query.operatorName.isEmpty())
        add(u"g.operator_name = ?"_s, {query.operatorName});
    if (!query.device.isEmpty())
        add(historyDeviceSql() + u" = ?"_s, {query.device});
    if (!query.batch.isEmpty()) // a batch leads to its squeezes: the time would to all
        add(u"g.id IN (SELECT b.grasp_id FROM inspections b WHERE b.batch_id IN "
            "(SELECT id FROM batches WHERE name = ?))"_s,
            {query.batch});
    if (!query.expected.isEmpty()) {
        m_needs |= Inspections;
        // In a form that no index is used for: of what is common the newest come first by time alone.
        add(u"COALESCE(i.expected_type, '') = ?"_s, {query.expected});
    }
    if (!query.type.isEmpty()) {
        m_needs |= Inspections | Types;
        add(historyTypeSql() + u" = ?"_s, {query.type});
    }
    if (query.outcome)
        addOutcome(*query.outcome);
    if (query.validity) {
        m_needs |= Inspections;
        add(historyValiditySql() + u" = ?"_s, {toString(*query.validity)});
    }
    if (query.text.isEmpty())
        return;
    if (textBy == TextBy::Keys)
        addSearch(query.text);
    else
        addText(query.text);
}

void HistorySelection::add(const QString& condition, const QStringList& values)
{
    m_conditions << condition;
    m_values << values;
}

void HistorySelection::addOutcome(InspectionOutcome outcome)
{
    m_needs |= Inspections;
    m_conditions << u"%1 = %2"_s.arg(historyOutcomeSql()).arg(int(outcome));
}

void HistorySelection::addText(const QString& text)
{
    m_needs |= Batches | Types;
    const QString pattern = containedPattern(text);
    QStringList places;
    QStringList values;
    for (const QString& column :
         {historyTypeSql(), u"COALESCE(i.expected_type, '')"_s, u"COALESCE(CAST(i.number AS TEXT), '')"_s,
          u"COALESCE(o.name, '')"_s, u"COALESCE(i.part_number, '')"_s, u"g.operator_name"_s, u"g.source"_s,
          u"g.part"_s, historyDeviceSql()}) {
        places << Database::containsSql(column);
        values << pattern;
    }
    add(u'(' + places.join(u" OR "_s) + u')', values);
}

void HistorySelection::addSearch(const QString& text)
{
    const TextSearch search = searchFor(text, mostNamed + 1);
    m_named = u"WITH named AS MATERIALIZED (%1) "_s.arg(search.sql);
    m_namedValues = search.values;
    m_conditions << u"g.id IN (SELECT id FROM named)"_s;
}

void HistorySelection::onlyVoided()
{
    m_needs |= Inspections;
    m_voided = true;
}

void HistorySelection::withoutVoided()
{
    m_needs |= Inspections;
    m_conditions << u"(i.id IS NULL OR i.id NOT IN (SELECT inspection_id FROM inspection_voids))"_s;
}

void HistorySelection::addBound(std::optional<Bound>& known, const Bound& bound)
{
    if (known) {
        const auto place = [](const Bound& of) { return std::pair(of.at.time, of.at.key); };
        const bool same = place(bound) == place(*known);
        const bool earlier = place(bound) < place(*known);
        if (same ? bound.inclusive : earlier != (&known == &m_upper))
            return;
    }
    known = bound;
}

void HistorySelection::onlyBehind(const HistoryMark& mark, bool backwards)
{
    if (!mark.key.isEmpty())
        addBound(backwards ? m_upper : m_lower,
                 {mark, false, u"(g.recorded_utc, g.id) %1 (?, ?)"_s.arg(backwards ? u"<"_s : u">"_s)});
}

void HistorySelection::onlyUpTo(const HistoryMark& mark, bool backwards)
{
    if (!mark.key.isEmpty())
        addBound(backwards ? m_lower : m_upper,
                 {mark, true, u"(g.recorded_utc, g.id) %1 (?, ?)"_s.arg(backwards ? u">="_s : u"<="_s)});
}

void HistorySelection::onlyOf(const HistoryList& list)
{
    onlyUpTo(list.newest, false);
    m_conditions << u"g.%1 <= %2"_s.arg(Database::orderOfInsertion()).arg(list.stored);
}

void HistorySelection::onlyOneIn(qint64 every)
{
    // Each number is looked up: to go through all of them takes seconds of ten million.
    m_conditions << u"g.id IN (SELECT y.grasp_id FROM inspections y WHERE y.number IN "
                    "(WITH RECURSIVE n(v) AS (SELECT CAST(%1 AS BIGINT) UNION ALL SELECT v + %1 FROM n "
                    "WHERE v + %1 <= (SELECT MAX(number) FROM inspections)) SELECT v FROM n) "
                    "UNION ALL SELECT h.id FROM grasps h WHERE h.type_id > '')"_s.arg(every);
}

namespace {

QString joinsBesideInspections(int needs)
{
    const auto has = [needs](HistorySelection::Need need) { return (needs & need) == need; };
    using Need = HistorySelection::Need;
    QString sql;
    if (has(Need::Batches))
        sql += u"LEFT JOIN batches o ON o.id = i.batch_id "_s;
    if (has(Need::Types))
        sql += grasp_table::typeJoins();
    if (has(Need::Estimates))
        sql += u"LEFT JOIN estimates e ON e.grasp_id = g.id AND e.rank = 0 "_s;
    return sql;
}

} // namespace

QString HistorySelection::from(int needs)
{
    QString sql = u"FROM grasps g "_s;
    if ((needs & Inspections) != 0)
        sql += u"LEFT JOIN inspections i ON i.grasp_id = g.id "_s;
    return sql + joinsBesideInspections(needs);
}

QString HistorySelection::fromWhere() const
{
    QStringList conditions = m_conditions;
    for (const std::optional<Bound>* bound : {&m_lower, &m_upper})
        if (*bound)
            conditions << (*bound)->sql;
    QString joins = from(m_needs);
    if (m_voided) { // few: they lead to their squeezes, in this order
        joins = u"FROM inspection_voids x CROSS JOIN inspections i CROSS JOIN grasps g "_s +
                joinsBesideInspections(m_needs);
        conditions << u"i.id = x.inspection_id"_s << u"g.id = i.grasp_id"_s;
    }
    return conditions.isEmpty() ? joins : joins + u"WHERE "_s + conditions.join(u" AND "_s) + u' ';
}

QString HistorySelection::orderBy() const
{
    const QString direction = m_query.descending ? u"DESC"_s : u"ASC"_s;
    const QString expression = factsOf(m_query.order).order;
    if (expression.isEmpty())
        return orderByTime(m_query.descending);
    return u"ORDER BY (%1) IS NULL, %1 %2, g.recorded_utc DESC, g.id DESC "_s.arg(expression, direction);
}

QString HistorySelection::ordered() const
{
    const QString expression = factsOf(m_query.order).order;
    return expression.isEmpty() ? u"NULL"_s : expression;
}

QString HistorySelection::orderByTime(bool backwards)
{
    return u"ORDER BY g.recorded_utc %1, g.id %1 "_s.arg(backwards ? u"DESC"_s : u"ASC"_s);
}

void HistorySelection::bind(Statement& statement) const
{
    for (const QString& value : m_namedValues)
        statement.bind(value);
    for (const QString& value : m_values)
        statement.bind(value);
    for (const std::optional<Bound>* bound : {&m_lower, &m_upper})
        if (*bound) {
            statement.bind((*bound)->at.time);
            if (!(*bound)->at.key.isEmpty())
                statement.bind((*bound)->at.key);
        }
}

} // namespace gripscope
