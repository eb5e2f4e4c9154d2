// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/migrations/migration.h"

namespace gripscope {

const char* const adjustmentsScript = R"sql(
-- Grippers whose squeezes are adjusted to types that were enrolled on another: the newest row of a serial number is in
-- force unless it has one in adjustment_ends. quantities, logarithms, covariance: the transfer error, as in
-- determined_quantities; types: names of those squeezed on both (JSON); enrolled_on: serial numbers (JSON).
CREATE TABLE gripper_adjustments (
  id TEXT PRIMARY KEY, station TEXT NOT NULL, created_utc TEXT NOT NULL, serial BIGINT NOT NULL,
  gripper_serial TEXT NOT NULL CHECK (gripper_serial <> ''), gripper_name TEXT NOT NULL,
  enrolled_on TEXT NOT NULL, types TEXT NOT NULL, squeezes BIGINT NOT NULL CHECK (squeezes >= 0),
  quantities TEXT NOT NULL CHECK (quantities <> ''), logarithms TEXT NOT NULL, covariance TEXT NOT NULL,
  degrees_of_freedom DOUBLE PRECISION NOT NULL, p_value DOUBLE PRECISION NOT NULL,
  agreement DOUBLE PRECISION NOT NULL, misfit DOUBLE PRECISION NOT NULL,
  study_id TEXT REFERENCES studies (id),
  library_version BIGINT NOT NULL, program TEXT NOT NULL,
  operator_name TEXT NOT NULL, reason TEXT NOT NULL CHECK (reason <> ''));
CREATE INDEX gripper_adjustments_of_gripper ON gripper_adjustments (gripper_serial, serial);

CREATE TABLE adjustment_ends (
  id TEXT PRIMARY KEY, station TEXT NOT NULL, created_utc TEXT NOT NULL,
  adjustment_id TEXT NOT NULL UNIQUE REFERENCES gripper_adjustments (id),
  operator_name TEXT NOT NULL, reason TEXT NOT NULL CHECK (reason <> ''));

-- The adjustment that an inspection was judged with; empty: none.
ALTER TABLE inspections ADD COLUMN adjustment_id TEXT NOT NULL DEFAULT '';
)sql";

} // namespace gripscope
