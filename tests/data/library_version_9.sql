-- What version 9 of the schema added to library_version_8.sql.
-- Do not edit: it stands for the files that users have.
INSERT INTO schema_migrations VALUES (9, 'batches, and codes of types', '3f2565d5ab259e5129148646da42fe3cc2fa526dba3245630a347515c0c0ead7', '0.8.0', 'plant-1', '2024-09-30T12:00:00.000Z');
-- Parts that are inspected and counted together, until as many as target were as expected.
CREATE TABLE batches (
  id TEXT PRIMARY KEY, station TEXT NOT NULL, begun_utc TEXT NOT NULL,
  name TEXT NOT NULL CHECK (name <> ''),
  target BIGINT NOT NULL CHECK (target >= 1),
  expected_type TEXT NOT NULL,
  operator_name TEXT NOT NULL);
CREATE INDEX batches_of_station ON batches (station, begun_utc, id);

CREATE TABLE batch_ends (
  id TEXT PRIMARY KEY, station TEXT NOT NULL, ended_utc TEXT NOT NULL,
  batch_id TEXT NOT NULL UNIQUE REFERENCES batches (id),
  operator_name TEXT NOT NULL);

ALTER TABLE inspections ADD COLUMN batch_id TEXT REFERENCES batches (id);
CREATE INDEX inspections_of_batch ON inspections (batch_id, verdict, expected_type, type_name);

-- What a scanner reads on the parts of a type, from a version of the library on.
ALTER TABLE type_states ADD COLUMN code TEXT NOT NULL DEFAULT '';
INSERT INTO batches VALUES ('n1', 'plant-1', '2024-09-30T12:05:00.000Z', '4711', 400, 'Can', 'Ada');
