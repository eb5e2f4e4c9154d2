// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/store/approval_table.h"

namespace gripscope::approval_table {

using namespace Qt::StringLiterals;

Expected<void> insert(Database& database, const RowStamp& stamp, const QString& typeId,
                      const QString& operatorName)
{
    Statement row(
        database, u"approve the type"_s,
        u"INSERT INTO approvals (id, station, approved_utc, type_id, operator_name) VALUES (?, ?, ?, ?, ?)"_s);
    return row.bind(stamp.id).bind(stamp.station).bind(stamp.utc).bind(typeId).bind(operatorName).run();
}

} // namespace gripscope::approval_table
