-- A library as version 1 of the schema left it: one approved type with one squeeze, and one inspection.
-- Do not edit: it stands for the files that users have.
CREATE TABLE schema_migrations (version INTEGER PRIMARY KEY, name TEXT NOT NULL, checksum TEXT NOT NULL, program TEXT NOT NULL, station TEXT NOT NULL, applied_utc TEXT NOT NULL);
INSERT INTO schema_migrations VALUES (1, 'types, squeezes and inspections', '3fe0d89f2b05a7707d258048112e93e811eaeedda21d2fd53aa4554bb97e77c9', '0.1.0', 'plant-1', '2024-05-31T12:00:00.000Z');
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
  packed BLOB NOT NULL);

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
INSERT INTO types VALUES ('t1', 'plant-1', '2024-05-31T12:00:00.000Z', 'Can');
INSERT INTO type_versions VALUES ('v1', 'plant-1', '2024-05-31T12:00:00.000Z', 't1', 1, 'squeeze-10N', 10, 20, 0.005, 1, 40, 0.02, 'N', 'm');
INSERT INTO type_versions VALUES ('v2', 'plant-1', '2024-05-31T12:01:00.000Z', 't1', 2, 'squeeze-11N', 11, 20, 0.005, 1, 40, 0.02, 'N', 'm');
INSERT INTO approvals VALUES ('a1', 'plant-1', '2024-05-31T12:02:00.000Z', 't1', 'Ada');
INSERT INTO grasps VALUES ('g1', 'plant-1', '2024-05-31T12:03:00.000Z', 't1', 'Ada', 'virtual:', 'N', 'm');
INSERT INTO grasps VALUES ('g2', 'plant-1', '2024-05-31T12:04:00.000Z', 't1', 'Ada', 'virtual:', 'N', 'm');
INSERT INTO grasps VALUES ('g3', 'plant-1', '2024-05-31T12:05:00.000Z', NULL, 'Ada', 'virtual:', 'N', 'm');
INSERT INTO estimates (id, station, created_utc, grasp_id, rank, estimator, status, message, program, m, b, k, iterations)
VALUES ('e1', 'plant-1', '2024-05-31T12:03:00.000Z', 'g1', 0, 'oe', 'converged', '', '0.1.0', 0.04, 43, 9990, 9);
INSERT INTO estimates (id, station, created_utc, grasp_id, rank, estimator, status, message, program, m, b, k, iterations)
VALUES ('e2', 'plant-1', '2024-05-31T12:04:00.000Z', 'g2', 0, 'oe', 'converged', '', '0.1.0', 0.04, 43, 5000, 9);
INSERT INTO decisions VALUES ('d1', 'plant-1', '2024-05-31T12:04:30.000Z', 'g2', 'dropped', 'slipped', 'Ada');
INSERT INTO inspections VALUES ('i1', 'plant-1', '2024-05-31T12:05:00.000Z', 7, 'g3', 'Can', 'unknown', '', 'Can', 0.5, 100, 15, 500, 0.01, 0.001, 1, 'Ada', '{"Can":1}', '["It was so."]');
