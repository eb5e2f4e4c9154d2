// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/migrations/migration.h"

namespace gripscope {

const char* const migrationScript1 = R"sql(
-- Types. What may change later (recipe, units, approval) is in tables of its own, one row a change.
CREATE TABLE types (
  id TEXT PRIMARY KEY, station TEXT NOT NULL, created_utc TEXT NOT NULL,
  name TEXT NOT NULL UNIQUE CHECK (name <> ''));

CREATE TABLE type_versions (
  id TEXT PRIMARY KEY, station TEXT NOT NULL, created_utc TEXT NOT NULL,
  type_id TEXT NOT NULL REFERENCES types (id),
  version INTEGER NOT NULL CHECK (version >= 1),
  recipe_name TEXT NOT NULL,
  peak_n DOUBLE PRECISION NOT NULL, bias_n DOUBLE PRECISION NOT NULL,
  bit_s DOUBLE PRECISION NOT NULL, seconds DOUBLE PRECISION NOT NULL,
  max_force_n DOUBLE PRECISION NOT NULL, max_travel_m DOUBLE PRECISION NOT NULL,
  force_unit TEXT NOT NULL, position_unit TEXT NOT NULL,
  UNIQUE (type_id, version));

CREATE TABLE approvals (
  id TEXT PRIMARY KEY, station TEXT NOT NULL, approved_utc TEXT NOT NULL,
  type_id TEXT NOT NULL REFERENCES types (id),
  operator_name TEXT NOT NULL);
CREATE INDEX approvals_of_type ON approvals (type_id);

-- Squeezes: with a type they belong to its enrolment, without one to an inspection.
CREATE TABLE grasps (
  id TEXT PRIMARY KEY, station TEXT NOT NULL, recorded_utc TEXT NOT NULL,
  type_id TEXT REFERENCES types (id),
  operator_name TEXT NOT NULL, source TEXT NOT NULL,
  force_unit TEXT NOT NULL, position_unit TEXT NOT NULL);
CREATE INDEX grasps_of_type ON grasps (type_id, recorded_utc, id);

CREATE TABLE recordings (
  id TEXT PRIMARY KEY, station TEXT NOT NULL, created_utc TEXT NOT NULL,
  grasp_id TEXT NOT NULL UNIQUE REFERENCES grasps (id),
  samples BIGINT NOT NULL,
  bytes BIGINT NOT NULL,
  sha256 TEXT NOT NULL,
  packed {blob} NOT NULL);

-- rank 0 is the recommended estimate. Covariance: of m, b, k, its upper triangle.
CREATE TABLE estimates (
  id TEXT PRIMARY KEY, station TEXT NOT NULL, created_utc TEXT NOT NULL,
  grasp_id TEXT NOT NULL REFERENCES grasps (id),
  rank INTEGER NOT NULL,
  estimator TEXT NOT NULL, status TEXT NOT NULL, message TEXT NOT NULL, program TEXT NOT NULL,
  m DOUBLE PRECISION, b DOUBLE PRECISION, k DOUBLE PRECISION,
  var_m DOUBLE PRECISION, cov_mb DOUBLE PRECISION, cov_mk DOUBLE PRECISION,
  var_b DOUBLE PRECISION, cov_bk DOUBLE PRECISION, var_k DOUBLE PRECISION,
  x0 DOUBLE PRECISION, v0 DOUBLE PRECISION, position_offset DOUBLE PRECISION,
  a1 DOUBLE PRECISION, a2 DOUBLE PRECISION, b1 DOUBLE PRECISION, b2 DOUBLE PRECISION, constant DOUBLE PRECISION,
  simulation_fit_percent DOUBLE PRECISION, prediction_fit_percent DOUBLE PRECISION,
  sse DOUBLE PRECISION, degrees_of_freedom DOUBLE PRECISION,
  whiteness_p DOUBLE PRECISION, input_independence_p DOUBLE PRECISION,
  iterations INTEGER NOT NULL,
  UNIQUE (grasp_id, rank));

-- The identify document as it was, apart from the squeeze's own row so that lists stay quick.
CREATE TABLE documents (
  id TEXT PRIMARY KEY, station TEXT NOT NULL, created_utc TEXT NOT NULL,
  grasp_id TEXT NOT NULL UNIQUE REFERENCES grasps (id),
  document TEXT NOT NULL);

-- What became of a squeeze after it was stored.
CREATE TABLE decisions (
  id TEXT PRIMARY KEY, station TEXT NOT NULL, decided_utc TEXT NOT NULL,
  grasp_id TEXT NOT NULL REFERENCES grasps (id),
  kind TEXT NOT NULL CHECK (kind IN ('dropped')),
  reason TEXT NOT NULL, operator_name TEXT NOT NULL);
CREATE INDEX decisions_of_grasp ON decisions (grasp_id);

CREATE TABLE inspections (
  id TEXT PRIMARY KEY, station TEXT NOT NULL, inspected_utc TEXT NOT NULL,
  number BIGINT NOT NULL UNIQUE CHECK (number >= 1),
  grasp_id TEXT NOT NULL UNIQUE REFERENCES grasps (id),
  expected_type TEXT NOT NULL,
  verdict TEXT NOT NULL, type_name TEXT NOT NULL, nearest TEXT NOT NULL,
  posterior DOUBLE PRECISION, distance DOUBLE PRECISION, gate DOUBLE PRECISION,
  samples_used BIGINT NOT NULL,
  false_reject DOUBLE PRECISION NOT NULL, wrong_type DOUBLE PRECISION NOT NULL,
  seconds DOUBLE PRECISION NOT NULL,
  operator_name TEXT NOT NULL,
  posteriors TEXT NOT NULL, reasons TEXT NOT NULL);
CREATE INDEX inspections_by_verdict ON inspections (verdict, number);
CREATE INDEX inspections_outcome ON inspections (verdict, expected_type, type_name);
)sql";

} // namespace gripscope
