// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/migrations/migration.h"

namespace gripscope {

const char* const migrationScript13 = R"sql(
-- What was in force when an inspection was judged. NULL, and an empty program: not recorded, a row from before. confidence
-- is NULL too where the false-reject rate was to hold on average, stranger_accept being there then.
ALTER TABLE inspections ADD COLUMN stranger_accept DOUBLE PRECISION;
ALTER TABLE inspections ADD COLUMN confidence DOUBLE PRECISION;
ALTER TABLE inspections ADD COLUMN robust INTEGER;
ALTER TABLE inspections ADD COLUMN library_version BIGINT;
ALTER TABLE inspections ADD COLUMN program TEXT NOT NULL DEFAULT '';
-- Ids of the validity checks that the measurement failed, with blanks between.
ALTER TABLE inspections ADD COLUMN checks_failed TEXT NOT NULL DEFAULT '';

-- By which calibration a channel was corrected: when it was taken, against what, until when; and its key. Empty: by none.
-- NULL: not recorded.
ALTER TABLE grasps ADD COLUMN force_calibration TEXT;
ALTER TABLE grasps ADD COLUMN force_calibration_id TEXT NOT NULL DEFAULT '';
ALTER TABLE grasps ADD COLUMN position_calibration TEXT;
ALTER TABLE grasps ADD COLUMN position_calibration_id TEXT NOT NULL DEFAULT '';
)sql";

} // namespace gripscope
