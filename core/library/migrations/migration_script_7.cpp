// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/migrations/migration.h"

namespace gripscope {

const char* const migrationScript7 = R"sql(
-- An object of known m, b, k that a gripper is checked on; the newest row of a serial number is in use. SI.
-- m and b: all three columns or none. interval_hours: how long a check holds, 0 where none is asked for.
CREATE TABLE reference_objects (
  id TEXT PRIMARY KEY, station TEXT NOT NULL, created_utc TEXT NOT NULL,
  gripper_serial TEXT NOT NULL CHECK (gripper_serial <> ''),
  name TEXT NOT NULL CHECK (name <> ''), certificate TEXT NOT NULL,
  m DOUBLE PRECISION, m_uncertainty DOUBLE PRECISION, m_tolerance DOUBLE PRECISION,
  b DOUBLE PRECISION, b_uncertainty DOUBLE PRECISION, b_tolerance DOUBLE PRECISION,
  k DOUBLE PRECISION NOT NULL, k_uncertainty DOUBLE PRECISION NOT NULL, k_tolerance DOUBLE PRECISION NOT NULL,
  bias_n DOUBLE PRECISION NOT NULL, peak_n DOUBLE PRECISION NOT NULL,
  squeezes INTEGER NOT NULL CHECK (squeezes > 0), interval_hours INTEGER NOT NULL CHECK (interval_hours >= 0),
  operator_name TEXT NOT NULL);
CREATE INDEX reference_objects_of_gripper ON reference_objects (gripper_serial, created_utc, id);

-- A check on it: what was found, with standard uncertainties. Nothing was found where the squeezes were not valid.
CREATE TABLE reference_checks (
  id TEXT PRIMARY KEY, station TEXT NOT NULL, created_utc TEXT NOT NULL,
  gripper_serial TEXT NOT NULL, reference_id TEXT NOT NULL REFERENCES reference_objects (id),
  verdict TEXT NOT NULL CHECK (verdict IN ('passed', 'failed', 'not_valid')),
  obstacle TEXT NOT NULL, squeezes INTEGER NOT NULL,
  m DOUBLE PRECISION, m_uncertainty DOUBLE PRECISION,
  b DOUBLE PRECISION, b_uncertainty DOUBLE PRECISION,
  k DOUBLE PRECISION, k_uncertainty DOUBLE PRECISION,
  operator_name TEXT NOT NULL);
CREATE INDEX reference_checks_of_gripper ON reference_checks (gripper_serial, created_utc, id);
)sql";

} // namespace gripscope
