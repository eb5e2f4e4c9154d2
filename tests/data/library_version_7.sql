-- What version 7 of the schema added to library_version_6.sql.
-- Do not edit: it stands for the files that users have.
INSERT INTO schema_migrations VALUES (7, 'checks on a reference object', 'f7842ddc6ff44aaf6c12793077c3dd46143fa76204f9f993dba6a89c7f6c566c', '0.6.0', 'plant-1', '2024-09-30T12:00:00.000Z');
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
INSERT INTO reference_objects VALUES ('o1', 'plant-1', '2024-09-30T12:03:00.000Z', '0001', 'Spring 10', 'D-K-4712', NULL, NULL, NULL, NULL, NULL, NULL, 10000, 20, 100, 20, 10, 3, 24, 'Ada');
INSERT INTO reference_checks VALUES ('h1', 'plant-1', '2024-09-30T12:04:00.000Z', '0001', 'o1', 'passed', '', 3, NULL, NULL, NULL, NULL, 10010, 8, 'Ada');
