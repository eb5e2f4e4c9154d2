// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/store/history_selection.h"

#include "core/signal/units.h"
#include "core/store/grasp_table.h"

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

/// The number of an InspectionOutcome; NULL for a squeeze that was not inspected.
QString outcomeSql()
{
    return u"CASE i.verdict WHEN 'type' THEN CASE WHEN i.expected_type IN ('', i.type_name) THEN 0 ELSE 1 "
           u"END "
           u"WHEN 'unknown' THEN 2 WHEN 'inconclusive' THEN 3 WHEN 'invalid' THEN 4 END"_s;
}

struct Ordering {
    QString expression;
    int needs = HistorySelection::None;
};

Ordering ordering(HistoryOrder order)
{
    using Selection = HistorySelection;
    const auto word = [](const QString& column) { return u"LOWER(NULLIF(%1, ''))"_s.arg(column); };
    switch (order) {
    case HistoryOrder::Time:
        break;
    case HistoryOrder::Number:
        return {u"i.number"_s, Selection::Inspections};
    case HistoryOrder::Kind:
        return {u"CASE WHEN g.type_id IS NULL THEN 0 ELSE 1 END"_s};
    case HistoryOrder::Expected:
        return {word(u"i.expected_type"_s), Selection::Inspections};
    case HistoryOrder::Outcome:
        return {outcomeSql(), Selection::Inspections};
    case HistoryOrder::Type:
        return {word(historyTypeSql()), Selection::Inspections | Selection::Types};
    case HistoryOrder::Posterior:
        return {u"CASE WHEN i.verdict IN ('type', 'inconclusive') THEN i.posterior END"_s,
                Selection::Inspections};
    case HistoryOrder::Mass:
        return {historySiSql(u"e.m"_s), Selection::Estimates};
    case HistoryOrder::Damping:
        return {historySiSql(u"e.b"_s), Selection::Estimates};
    case HistoryOrder::Stiffness:
        return {historySiSql(u"e.k"_s), Selection::Estimates};
    case HistoryOrder::Fit:
        return {u"e.simulation_fit_percent"_s, Selection::Estimates};
    case HistoryOrder::Seconds:
        return {u"i.seconds"_s, Selection::Inspections};
    case HistoryOrder::Operator:
        return {word(u"g.operator_name"_s)};
    case HistoryOrder::Device:
        return {word(historyDeviceSql())};
    case HistoryOrder::Batch:
        return {word(u"o.name"_s), Selection::Batches};
    case HistoryOrder::Estimator:
        return {u"e.estimator"_s, Selection::Estimates};
    case HistoryOrder::Program:
        return {u"e.program"_s, Selection::Estimates};
    }
    return {};
}

} // namespace

QString historyTypeSql()
{
    return u"COALESCE(i.type_name, s.name, '')"_s;
}

QString historyDeviceSql()
{
    return u"TRIM(g.device_name || ' ' || g.device_serial)"_s;
}

QString historySiSql(const QString& column)
{
    static const QStringList forces{u"N"_s, u"mN"_s, u"kN"_s, u"uN"_s, u"\u00b5N"_s, u"\u03bcN"_s};
    static const QStringList positions{u"m"_s,  u"mm"_s,      u"cm"_s,     u"um"_s,
                                       u"nm"_s, u"\u00b5m"_s, u"\u03bcm"_s};
    static const QString factor =
        u"COALESCE(%1 / %2, 1)"_s.arg(factorSql(u"g.force_unit"_s, forces, newtonsPer),
                                      factorSql(u"g.position_unit"_s, positions, metresPer));
    return u"%1 * %2"_s.arg(column, factor);
}

HistorySelection::HistorySelection(const HistoryQuery& query, int needs) : m_query(query), m_needs(needs)
{
    m_needs |= ordering(query.order).needs;
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
    m_conditions << u"%1 = %2"_s.arg(outcomeSql()).arg(int(outcome));
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
    const QString expression = ordering(m_query.order).expression;
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
