// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/store/reidentification_table.h"

#include "core/words.h"

namespace gripscope::reidentification_table {

using namespace Qt::StringLiterals;

Expected<void> insert(Database& database, const RowStamp& stamp, const QString& graspId,
                      const QString& estimateId, const Reidentification& how)
{
    Statement row(
        database, Words::tr("store the estimate"),
        u"INSERT INTO reidentifications (id, station, created_utc, estimate_id, grasp_id, force_hold, "
        "initial_state, free_offset, operator_name) VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?)"_s);
    row.bind(stamp.id).bind(stamp.station).bind(stamp.utc).bind(estimateId).bind(graspId);
    row.bind(how.hold ? toString(*how.hold) : QString())
        .bind(how.initialState == InitialState::Free ? u"free"_s : u"rest"_s);
    return row.bind(how.freeOffset ? 1 : 0).bind(how.operatorName).run();
}

} // namespace gripscope::reidentification_table
