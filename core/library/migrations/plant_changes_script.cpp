// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/migrations/migration.h"

namespace gripscope {

// 70: library_meetings in the ledger.
const char* const plantChangesScript = R"sql(
-- What the changes of a plant are worked out from, among the numbers and deliveries of millions of inspections.
CREATE INDEX library_meetings_of_changes ON library_meetings (version) WHERE seen <> '{}';
CREATE INDEX library_meetings_with_servers ON library_meetings (id) WHERE heads = '{}';
CREATE INDEX merged_rows_of_meetings ON merged_rows (library) WHERE table_code = 70;
)sql";

} // namespace gripscope
