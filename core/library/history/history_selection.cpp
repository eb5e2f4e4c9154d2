// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/history/history_fields.h"
#include "core/library/history/history_view.h"
#include "core/library/tables/grasp_table.h"
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
    return u"CASE i.verdict WHEN 'type' THEN CASE WHEN i.expected_type IN ('', i.type_name) THEN 0 ELSE 1 "
           u"END "
           u"WHEN 'unknown' THEN 2 WHEN 'inconclusive' THEN 3 WHEN 'invalid' THEN 4 END"_s;
}

QString historyDeviceSql()
{
    return u"TRIM(g.device_name || ' ' || g.device_serial)"_s;
}

QString historySiSql(const QString& column)
{
    static const QString factor =
        u"COALESCE(%1 / %2, 1)"_s.arg(factorSql(u"g.force_unit"_s, forceUnits(), newtonsPer),
                                      factorSql(u"g.position_unit"_s, positionUnits(), metresPer));
    return u"%1 * %2"_s.arg(column, factor);
}

HistorySelection::HistorySelection(const HistoryQuery& query, int needs) : m_query(query), m_needs(needs)
{
    m_needs |= factsOf(query.order).needs;
    if (query.kind)
        m_conditions << (*query.kind == SqueezeKind::Enrollment ? u"g.type_id IS NOT NULL"_s
                                                                : u"g.type_id IS NULL"_s);
    if (query.from.isValid())
        add(u"g.recorded_utc >= ?"_s, {utcText(query.from)});
    if (query.to.isValid())
        add(u"g.recorded_utc < ?"_s, {utcText(query.to)});
    if (!query.operatorName.isEmpty())
        add(u"g.operator_name = ?"_s, {query.operatorName});
    if (!query.device.isEmpty())
        add(historyDeviceSql() + u" = ?"_s, {query.device});
    if (!query.batch.isEmpty()) {
        m_needs |= Batches;
        add(u"o.name = ?"_s, {query.batch});
    }
    if (!query.expected.isEmpty()) {
        m_needs |= Inspections;
        add(u"i.expected_type = ?"_s, {query.expected});
    }
    if (!query.type.isEmpty()) {
        m_needs |= Inspections | Types;
        add(historyTypeSql() + u" = ?"_s, {query.type});
    }
    if (query.outcome)
        addOutcome(*query.outcome);
    if (!query.text.isEmpty())
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
    QString pattern = text;
    pattern.replace(u'!', "!!"_L1).replace(u'%', "!%"_L1).replace(u'_', "!_"_L1);
    pattern = u'%' + pattern + u'%';
    QStringList places;
    QStringList values;
    for (const QString& column :
         {historyTypeSql(), u"COALESCE(i.expected_type, '')"_s, u"COALESCE(CAST(i.number AS TEXT), '')"_s,
          u"COALESCE(o.name, '')"_s, u"g.operator_name"_s, u"g.source"_s, u"g.part"_s, historyDeviceSql()}) {
        places << u"LOWER(%1) LIKE LOWER(?) ESCAPE '!'"_s.arg(column);
        values << pattern;
    }
    add(u'(' + places.join(u" OR "_s) + u')', values);
}

QString HistorySelection::from(int needs)
{
    const auto has = [needs](Need need) { return (needs & need) == need; };
    QString sql = u"FROM grasps g "_s;
    if (has(Inspections))
        sql += u"LEFT JOIN inspections i ON i.grasp_id = g.id "_s;
    if (has(Batches))
        sql += u"LEFT JOIN batches o ON o.id = i.batch_id "_s;
    if (has(Types))
        sql += grasp_table::typeJoins();
    if (has(Estimates))
        sql += u"LEFT JOIN estimates e ON e.grasp_id = g.id AND e.rank = 0 "_s;
    return sql;
}

QString HistorySelection::fromWhere() const
{
    const QString joins = from(m_needs);
    return m_conditions.isEmpty() ? joins : joins + u"WHERE "_s + m_conditions.join(u" AND "_s) + u' ';
}

QString HistorySelection::orderBy() const
{
    const QString direction = m_query.descending ? u"DESC"_s : u"ASC"_s;
    const QString expression = factsOf(m_query.order).order;
    if (expression.isEmpty())
        return u"ORDER BY g.recorded_utc %1, g.id %1"_s.arg(direction);
    return u"ORDER BY (%1) IS NULL, %1 %2, g.recorded_utc DESC, g.id DESC"_s.arg(expression, direction);
}

void HistorySelection::bind(Statement& statement) const
{
    for (const QString& value : m_values)
        statement.bind(value);
}

} // namespace gripscope
