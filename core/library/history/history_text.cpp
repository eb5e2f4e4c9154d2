// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/history/history_text.h"

#include "core/library/history/history_view.h"
#include "core/library/sql/database.h"
#include "core/library/tables/grasp_table.h"

#include <algorithm>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

/// The values of a column that many rows share, of which the text is contained in.
QString sharedValues(const QString& table, const QString& column)
{
    return u"SELECT value FROM (%1) AS shared WHERE %2"_s.arg(distinctSql(table, column),
                                                              Database::containsSql(u"value"_s));
}

/// The values of a column that holds another one in each row. More than `most` of them are too many anyway.
QString ownValues(const QString& table, const QString& column, const QString& compared,
                  const QString& condition, qint64 most)
{
    return u"SELECT %1 FROM %2 WHERE %3%4 LIMIT %5"_s
        .arg(column, table, condition, Database::containsSql(compared))
        .arg(most);
}

QString squeezesWith(const QString& column, const QString& values, const QString& condition = {})
{
    return u"SELECT id FROM grasps WHERE %1%2 IN (%3)"_s.arg(condition, column, values);
}

QString inspectionsWith(const QString& column, const QString& values, const QString& condition = {})
{
    return u"SELECT grasp_id FROM inspections WHERE %1%2 IN (%3)"_s.arg(condition, column, values);
}

bool onlyDigits(const QString& text)
{
    return std::all_of(text.cbegin(), text.cend(),
                       [](QChar sign) { return sign >= QLatin1Char('0') && sign <= QLatin1Char('9'); });
}

} // namespace

QString distinctSql(const QString& table, const QString& column)
{
    return u"WITH RECURSIVE each_one(value) AS (SELECT MIN(%2) FROM %1 UNION ALL "
           "SELECT (SELECT MIN(%2) FROM %1 WHERE %2 > each_one.value) FROM each_one "
           "WHERE each_one.value IS NOT NULL) SELECT value FROM each_one WHERE value IS NOT NULL"_s.arg(
               table, column);
}

QString containedPattern(const QString& text)
{
    QString pattern = text;
    pattern.replace(u'!', "!!"_L1).replace(u'%', "!%"_L1).replace(u'_', "!_"_L1);
    return u'%' + pattern + u'%';
}

TextSearch searchFor(const QString& text, qint64 most)
{
    const QString device = u"TRIM(device_name || ' ' || device_serial)"_s; // as historyDeviceSql()
    const QString somePart = u"part <> '' AND "_s;
    const QString someNumber = u"part_number <> '' AND "_s;
    QStringList places{
        squeezesWith(u"operator_name"_s, sharedValues(u"grasps"_s, u"operator_name"_s)),
        squeezesWith(device, sharedValues(u"grasps"_s, device)),
        squeezesWith(u"source"_s, ownValues(u"grasps"_s, u"source"_s, u"source"_s, {}, most)),
        squeezesWith(u"part"_s, ownValues(u"grasps"_s, u"part"_s, u"part"_s, somePart, most), somePart),
        inspectionsWith(u"type_name"_s, sharedValues(u"inspections"_s, u"type_name"_s)),
        inspectionsWith(u"expected_type"_s, sharedValues(u"inspections"_s, u"expected_type"_s)),
        inspectionsWith(u"batch_id"_s, u"SELECT id FROM batches WHERE "_s + Database::containsSql(u"name"_s)),
        inspectionsWith(u"part_number"_s,
                        ownValues(u"inspections"_s, u"part_number"_s, u"part_number"_s, someNumber, most),
                        someNumber),
        u"SELECT g.id FROM grasps g %1 WHERE g.type_id > '' AND %2"_s.arg(
            grasp_table::typeJoins(), Database::containsSql(u"s.name"_s))};
    if (onlyDigits(text)) // no number contains anything else
        places << inspectionsWith(
            u"number"_s, ownValues(u"inspections"_s, u"number"_s, u"CAST(number AS TEXT)"_s, {}, most));
    TextSearch search;
    search.sql = u"SELECT id FROM (%1) AS places LIMIT %2"_s.arg(places.join(u" UNION ALL "_s)).arg(most);
    search.values = QStringList(places.size(), containedPattern(text));
    return search;
}

} // namespace gripscope
