// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/store/decision_table.h"

namespace gripscope::decision_table {

using namespace Qt::StringLiterals;

Expected<void> insertDrop(Database& database, const RowStamp& stamp, const QString& graspId,
                          const QString& reason, const QString& operatorName)
{
    Statement row(database, u"drop the squeeze"_s,
                  u"INSERT INTO decisions (id, station, decided_utc, grasp_id, kind, reason, operator_name) "
                  "VALUES (?, ?, ?, ?, 'dropped', ?, ?)"_s);
    row.bind(stamp.id).bind(stamp.station).bind(stamp.utc).bind(graspId).bind(reason).bind(operatorName);
    return row.run();
}

} // namespace gripscope::decision_table
