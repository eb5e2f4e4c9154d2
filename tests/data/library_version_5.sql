-- What version 5 of the schema added to library_version_4.sql, with one calibration.
-- Do not edit: it stands for the files that users have.
INSERT INTO schema_migrations VALUES (5, 'calibrations of sensors', 'ec80b874498ca7ec92bac62d324aa44dbb2303a2826586f7085a908edb3d760b', '0.4.0', 'plant-1', '2024-09-30T12:00:00.000Z');
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
INSERT INTO calibrations VALUES ('k1', 'plant-1', '2024-09-30T12:01:00.000Z', '0001', 'Gripper 0001', 'force', 'N', 'weights', 'DKD-1', 0.01, 0, 1, '0 0.1
10 10.1
20 20.1', '2024-09-30T12:00:00.000Z', '2025-09-30', 'Ada', '');
