// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/migrations/migration.h"

namespace gripscope {

const char* const processChartsScript = R"sql(
-- What control charts of a type are drawn from, each in one index (which holds verdict and rank: an index of
-- those rows alone is no longer read by itself): about 300 bytes an inspection.
CREATE INDEX inspections_of_charts ON inspections
  (type_name, verdict, grasp_id, number, inspected_utc, station, operator_name, batch_id);
CREATE INDEX estimates_of_charts ON estimates (rank, grasp_id, m, b, k);
CREATE INDEX grasps_of_charts ON grasps (id, force_unit, position_unit, device_name, device_serial);
CREATE INDEX grasps_by_units ON grasps (force_unit, position_unit);

-- Limits of the charts of a type that somebody has fixed (JSON), in force from then on; empty: no longer fixed.
CREATE TABLE process_limits (
  id TEXT PRIMARY KEY, station TEXT NOT NULL, created_utc TEXT NOT NULL, serial BIGINT NOT NULL,
  type_name TEXT NOT NULL CHECK (type_name <> ''),
  limits TEXT NOT NULL, operator_name TEXT NOT NULL);
CREATE INDEX process_limits_of_type ON process_limits (type_name, serial);
)sql";

} // namespace gripscope
