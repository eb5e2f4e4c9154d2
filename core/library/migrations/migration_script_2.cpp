// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/migrations/migration.h"

namespace gripscope {

const char* const migrationScript2 = R"sql(
-- What is known of a gripper's channels; the newest row of a serial number is in force. Baseline: the empty gripper.
CREATE TABLE measuring_chains (
  id TEXT PRIMARY KEY, station TEXT NOT NULL, created_utc TEXT NOT NULL,
  gripper_serial TEXT NOT NULL CHECK (gripper_serial <> ''),
  force_lag_s DOUBLE PRECISION NOT NULL, force_lag_uncertainty_s DOUBLE PRECISION NOT NULL,
  force_scale_uncertainty DOUBLE PRECISION NOT NULL, position_scale_uncertainty DOUBLE PRECISION NOT NULL,
  frame_compliance DOUBLE PRECISION NOT NULL, frame_compliance_uncertainty DOUBLE PRECISION NOT NULL,
  baseline_m DOUBLE PRECISION, baseline_b DOUBLE PRECISION, baseline_k DOUBLE PRECISION,
  baseline_error_m DOUBLE PRECISION, baseline_error_b DOUBLE PRECISION, baseline_error_k DOUBLE PRECISION,
  operator_name TEXT NOT NULL, basis TEXT NOT NULL);
CREATE INDEX measuring_chains_of_gripper ON measuring_chains (gripper_serial, created_utc, id);
)sql";

} // namespace gripscope
