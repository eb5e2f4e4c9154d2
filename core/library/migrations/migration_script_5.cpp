// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/migrations/migration.h"

namespace gripscope {

const char* const migrationScript5 = R"sql(
-- A sensor of a gripper against a reference; the newest row of a serial number and channel is in force.
-- points: "load reading" a line, in the order they were taken. due_date: the last day it holds, YYYY-MM-DD.
CREATE TABLE calibrations (
  id TEXT PRIMARY KEY, station TEXT NOT NULL, created_utc TEXT NOT NULL,
  gripper_serial TEXT NOT NULL CHECK (gripper_serial <> ''), gripper_name TEXT NOT NULL,
  channel TEXT NOT NULL CHECK (channel IN ('force', 'position')), unit TEXT NOT NULL,
  reference_name TEXT NOT NULL, reference_certificate TEXT NOT NULL,
  reference_uncertainty DOUBLE PRECISION NOT NULL, reference_relative_uncertainty DOUBLE PRECISION NOT NULL,
  degree INTEGER NOT NULL, points TEXT NOT NULL,
  taken_utc TEXT NOT NULL, due_date TEXT NOT NULL,
  operator_name TEXT NOT NULL, note TEXT NOT NULL);
CREATE INDEX calibrations_of_gripper ON calibrations (gripper_serial, channel, created_utc, id);
)sql";

} // namespace gripscope
