// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/migrations/migration.h"

namespace gripscope {

const char* const migrationScript8 = R"sql(
-- Which gripper squeezed, for lists and filters; empty for squeezes stored before, whose recordings know it.
ALTER TABLE grasps ADD COLUMN device_name TEXT NOT NULL DEFAULT '';
ALTER TABLE grasps ADD COLUMN device_serial TEXT NOT NULL DEFAULT '';
ALTER TABLE grasps ADD COLUMN firmware TEXT NOT NULL DEFAULT '';
CREATE INDEX grasps_by_time ON grasps (recorded_utc, id, type_id);

-- Who identified a stored squeeze again, and how: one row for each estimate that came later.
-- force_hold: empty for that of the recording. What was judged from the first estimate stays as it was.
CREATE TABLE reidentifications (
  id TEXT PRIMARY KEY, station TEXT NOT NULL, created_utc TEXT NOT NULL,
  estimate_id TEXT NOT NULL UNIQUE REFERENCES estimates (id),
  grasp_id TEXT NOT NULL REFERENCES grasps (id),
  force_hold TEXT NOT NULL, initial_state TEXT NOT NULL CHECK (initial_state IN ('free', 'rest')),
  free_offset INTEGER NOT NULL CHECK (free_offset IN (0, 1)),
  operator_name TEXT NOT NULL);
CREATE INDEX reidentifications_of_grasp ON reidentifications (grasp_id);
)sql";

} // namespace gripscope
