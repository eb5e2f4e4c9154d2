// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/migrations/migration.h"

namespace gripscope {

const char* const migrationScript19 = R"sql(
-- By how much the clock of the station was ahead of UTC when it recorded the squeeze. NULL: not recorded.
ALTER TABLE grasps ADD COLUMN utc_offset_s BIGINT;

-- Each page of a history asks which clocks were set back.
CREATE INDEX audit_entries_of_clocks ON audit_entries (number) WHERE action = 'clock.back';
)sql";

} // namespace gripscope
