// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/tables/tally_table.h"

#include "core/base/words.h"
#include "core/library/sql/rows.h"
#include "core/library/tables/inspection_tables.h"

#include <array>
#include <map>
#include <optional>

namespace gripscope::tally_table {

using namespace Qt::StringLiterals;

namespace {

/// Verdict with how the part stood to its limits (partJudgedFromString()), expected type, type.
using Kind = std::array<QString, 3>;
using Tally = std::map<Kind, qint64>;

const auto newestTally = u"(SELECT COALESCE(MAX(up_to), 0) FROM inspection_tallies)"_s;
const auto kindColumns = u"verdict, expected_type, type_name"_s;

/// The same of inspections.
QString inspectedColumns()
{
    return inspection_table::judgedSql() + u" AS verdict, expected_type, type_name"_s;
}

QString countingInspections()
{
    return Words::tr("count the inspections");
}

Expected<Tally> tallied(Database& database, const QString& sql)
{
    Tally tally;
    Statement query(database, countingInspections(), sql);
    const auto done = query.forEach([&](Statement& row) {
        Kind kind;
        for (QString& part : kind)
            part = row.takeText();
        tally[kind] = row.takeInteger();
    });
    if (!done)
        return tl::unexpected(done.error());
    return tally;
}

Expected<qint64> numberOf(Database& database, const QString& sql)
{
    Statement query(database, countingInspections(), sql);
    return gripscope::numberOf(query);
}

} // namespace

QString countedSql()
{
    return u"(SELECT %1, n FROM inspection_tallies WHERE up_to = %2 UNION ALL SELECT %3, 1 FROM inspections "
           "WHERE number > %2)"_s.arg(kindColumns, newestTally, inspectedColumns());
}

Expected<void> keepUp(Database& database)
{
    ASSIGN_OR_RETURN(const qint64 upTo, numberOf(database, u"SELECT MAX(number) FROM inspections"_s));
    ASSIGN_OR_RETURN(const qint64 before, numberOf(database, u"SELECT "_s + newestTally));
    if (before > 0 && upTo - before < inspectionsBetween)
        return {};
    ASSIGN_OR_RETURN(const Tally tally,
                     tallied(database, u"SELECT %1, SUM(n) FROM %2 AS counted GROUP BY %1"_s.arg(
                                           kindColumns, countedSql())));
    for (const auto& [kind, n] : tally) {
        const RowStamp stamp = RowStamp::now();
        Statement row(database, Words::tr("store the inspection"),
                      u"INSERT INTO inspection_tallies (id, station, created_utc, up_to, verdict, "
                      "expected_type, type_name, n) VALUES (?, ?, ?, ?, ?, ?, ?, ?)"_s);
        row.bind(stamp.id).bind(stamp.station).bind(stamp.utc).bind(upTo);
        RETURN_IF_ERROR(row.bind(kind[0]).bind(kind[1]).bind(kind[2]).bind(n).run());
    }
    return {};
}

Expected<std::optional<qint64>> wrongUpTo(Database& database)
{
    ASSIGN_OR_RETURN(const qint64 upTo, numberOf(database, u"SELECT "_s + newestTally));
    ASSIGN_OR_RETURN(const Tally said,
                     tallied(database, u"SELECT %1, n FROM inspection_tallies WHERE up_to = %2"_s.arg(
                                           kindColumns, newestTally)));
    ASSIGN_OR_RETURN(
        const Tally counted,
        tallied(database, u"SELECT %1, COUNT(*) FROM inspections WHERE number <= %2 GROUP BY 1, 2, 3"_s.arg(
                              inspectedColumns(), newestTally)));
    return said == counted ? std::nullopt : std::optional(upTo);
}

} // namespace gripscope::tally_table
