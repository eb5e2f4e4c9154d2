-- What version 2 of the schema added to library_version_1.sql, with one gripper's channels.
-- Do not edit: it stands for the files that users have.
INSERT INTO schema_migrations VALUES (2, 'what is known of a gripper''s channels', '9372b5894d92b40436f836603ca4079adff5daaa3771bb30cafc6a3b373a5afe', '0.2.0', 'plant-1', '2024-06-30T12:00:00.000Z');
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
INSERT INTO measuring_chains VALUES ('c1', 'plant-1', '2024-06-30T12:01:00.000Z', '0001', 0.0001, 0.000002, 0.002, 0.001, 0.00001, 0.000001, 0.01, 2, 300, 0.001, 0.2, 30, 'Ada', 'lag from 5 squeezes');
