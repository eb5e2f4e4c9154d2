// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/tables/determined_table.h"

#include "core/base/words.h"
#include "core/library/records/determined_text.h"

namespace gripscope::determined_table {

using namespace Qt::StringLiterals;

Expected<void> insert(Database& database, const RowStamp& stamp, const QString& graspId,
                      const DeterminedQuantities& determined)
{
    const std::optional<DeterminedText> text = determinedText(determined);
    if (!text)
        return failure(ErrorCode::Usage, {Words::tr("An estimate holds a number that is not finite.")});
    Statement row(database, Words::tr("store the squeeze"),
                  u"INSERT INTO determined_quantities (id, station, created_utc, grasp_id, quantities, "
                  "logarithms, covariance) VALUES (?, ?, ?, ?, ?, ?, ?)"_s);
    row.bind(stamp.id).bind(stamp.station).bind(stamp.utc).bind(graspId);
    return row.bind(text->quantities).bind(text->logarithms).bind(text->covariance).run();
}

std::optional<DeterminedQuantities> take(Statement& row)
{
    DeterminedText text;
    for (QString* const column : {&text.quantities, &text.logarithms, &text.covariance})
        *column = row.takeText();
    return determinedQuantities(text);
}

} // namespace gripscope::determined_table
