// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/tables/process_limits_table.h"

#include "core/base/words.h"
#include "core/library/sql/rows.h"
#include "core/library/tables/serial.h"

namespace gripscope::process_limits_table {

using namespace Qt::StringLiterals;

namespace {

struct NumberedLimits {
    ProcessLimitsRecord record;
    qint64 serial = 0;
};

NumberedLimits takeProcessLimits(Statement& row)
{
    NumberedLimits limits;
    limits.record.type = row.takeText();
    limits.record.limits = row.takeText();
    limits.record.fixed = row.takeUtc();
    limits.record.operatorName = row.takeText();
    limits.serial = row.takeInteger();
    return limits;
}

} // namespace

Expected<void> insert(Database& database, const QString& type, const QString& limits,
                      const QString& operatorName)
{
    const RowStamp stamp = RowStamp::now();
    Statement row(database, Words::tr("fix the limits of the charts"),
                  u"INSERT INTO process_limits (id, station, created_utc, type_name, limits, operator_name, "
                  "serial) VALUES (?, ?, ?, ?, ?, ?, "_s +
                      nextSerial(u"process_limits"_s) + u')');
    row.bind(stamp.id).bind(stamp.station).bind(stamp.utc);
    return row.bind(type).bind(limits).bind(operatorName).run();
}

Expected<std::optional<ProcessLimitsRecord>> newest(Database& database,
                                                    const std::vector<TypeNameSpan>& names)
{
    std::optional<NumberedLimits> last;
    for (const TypeNameSpan& span : names) {
        Statement query(database, Words::tr("read the limits of the charts"),
                        u"SELECT type_name, limits, created_utc, operator_name, serial FROM process_limits "
                        "WHERE type_name = ? AND created_utc >= ? AND (? = '' OR created_utc < ?) "
                        "ORDER BY "_s +
                            newestFirst + u" LIMIT 1"_s);
        query.bind(span.name).bind(span.from).bind(span.until).bind(span.until);
        ASSIGN_OR_RETURN(const auto found, firstRow(query, takeProcessLimits));
        if (found && (!last || std::pair(found->serial, found->record.fixed) >
                                   std::pair(last->serial, last->record.fixed)))
            last = found;
    }
    return last ? std::optional(last->record) : std::nullopt;
}

} // namespace gripscope::process_limits_table
