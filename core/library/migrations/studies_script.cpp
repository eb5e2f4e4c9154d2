// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/migrations/migration.h"

namespace gripscope {

const char* const studiesScript = R"sql(
-- Studies of how well the gripper measures: plan (JSON) holds the design, its seed and every row in order, options (JSON)
-- how it is to be evaluated. A study without a row in study_ends is under way.
CREATE TABLE studies (
  id TEXT PRIMARY KEY, station TEXT NOT NULL, created_utc TEXT NOT NULL, serial BIGINT NOT NULL,
  kind TEXT NOT NULL CHECK (kind <> ''), name TEXT NOT NULL CHECK (name <> ''),
  plan TEXT NOT NULL CHECK (plan <> ''), options TEXT NOT NULL,
  gripper_serial TEXT NOT NULL,
  recipe_name TEXT NOT NULL,
  peak_n DOUBLE PRECISION NOT NULL, bias_n DOUBLE PRECISION NOT NULL,
  bit_s DOUBLE PRECISION NOT NULL, seconds DOUBLE PRECISION NOT NULL,
  max_force_n DOUBLE PRECISION NOT NULL, max_travel_m DOUBLE PRECISION NOT NULL,
  force_kind TEXT NOT NULL, force_levels TEXT NOT NULL,
  operator_name TEXT NOT NULL);

CREATE TABLE study_ends (
  id TEXT PRIMARY KEY, station TEXT NOT NULL, created_utc TEXT NOT NULL,
  study_id TEXT NOT NULL UNIQUE REFERENCES studies (id),
  state TEXT NOT NULL CHECK (state IN ('finished', 'abandoned')),
  reason TEXT NOT NULL, operator_name TEXT NOT NULL);

-- Each try at a row of the plan (counted from 0) as it was made. m, b, k with their standard uncertainties, in these units;
-- rating: what a rater said; reasons (JSON): why it is not valid; squeeze_id: where its raw recording is.
CREATE TABLE study_measurements (
  id TEXT PRIMARY KEY, station TEXT NOT NULL, created_utc TEXT NOT NULL, serial BIGINT NOT NULL,
  study_id TEXT NOT NULL REFERENCES studies (id),
  plan_row BIGINT NOT NULL CHECK (plan_row >= 0),
  outcome TEXT NOT NULL CHECK (outcome IN ('measured', 'invalid', 'skipped')),
  m DOUBLE PRECISION, m_error DOUBLE PRECISION,
  b DOUBLE PRECISION, b_error DOUBLE PRECISION,
  k DOUBLE PRECISION, k_error DOUBLE PRECISION,
  m_unit TEXT NOT NULL, b_unit TEXT NOT NULL, k_unit TEXT NOT NULL,
  rating TEXT NOT NULL, validity TEXT NOT NULL, reasons TEXT NOT NULL,
  gripper_serial TEXT NOT NULL, operator_name TEXT NOT NULL,
  squeeze_id TEXT REFERENCES draft_squeezes (id));
CREATE INDEX study_measurements_of_study ON study_measurements (study_id, serial);

-- Measurements that were taken back. Their rows stay as they were written.
CREATE TABLE study_undos (
  id TEXT PRIMARY KEY, station TEXT NOT NULL, created_utc TEXT NOT NULL,
  measurement_id TEXT NOT NULL UNIQUE REFERENCES study_measurements (id),
  reason TEXT NOT NULL, operator_name TEXT NOT NULL);
)sql";

} // namespace gripscope
