-- What version 11 of the schema added to library_version_10.sql.
-- Do not edit: it stands for the files that users have.
INSERT INTO schema_migrations VALUES (11, 'policies', '2ea73e00023618963a1eb478b8e0ee8bb8d4b4cab2a1fd37eb0cff22b1b118e4', '0.10.0', 'plant-1', '2024-11-30T12:00:00.000Z');
-- What a supervisor decided for all who work with this library: the newest version of a policy is in force.
CREATE TABLE policies (
  id TEXT PRIMARY KEY, station TEXT NOT NULL, created_utc TEXT NOT NULL,
  name TEXT NOT NULL, version INTEGER NOT NULL CHECK (version >= 1),
  value TEXT NOT NULL,
  UNIQUE (name, version));
