-- What version 6 of the schema added to library_version_5.sql.
-- Do not edit: it stands for the files that users have.
INSERT INTO schema_migrations VALUES (6, 'pictures of parts, and enrolments under way', 'f07cec2ca6f45dcb71f40d83f40432f15a1dbcc3245a9f1ce7e62eed29a6aa13', '0.5.0', 'plant-1', '2024-09-30T12:00:00.000Z');
-- Pictures of parts, as PNG or JPEG.
CREATE TABLE pictures (
  id TEXT PRIMARY KEY, station TEXT NOT NULL, created_utc TEXT NOT NULL,
  format TEXT NOT NULL CHECK (format IN ('png', 'jpeg')),
  width INTEGER NOT NULL, height INTEGER NOT NULL,
  sha256 TEXT NOT NULL,
  bytes BLOB NOT NULL);

-- Which picture a type has; the newest row of a type is in force. No picture: it was taken away.
CREATE TABLE type_pictures (
  id TEXT PRIMARY KEY, station TEXT NOT NULL, created_utc TEXT NOT NULL,
  type_id TEXT NOT NULL REFERENCES types (id),
  picture_id TEXT REFERENCES pictures (id),
  operator_name TEXT NOT NULL);
CREATE INDEX type_pictures_of_type ON type_pictures (type_id, id);

-- Squeezes of enrolments as they came from the gripper, before anybody decided on them.
CREATE TABLE draft_squeezes (
  id TEXT PRIMARY KEY, station TEXT NOT NULL, created_utc TEXT NOT NULL,
  type_name TEXT NOT NULL,
  source TEXT NOT NULL, part TEXT NOT NULL,
  bytes BIGINT NOT NULL,
  sha256 TEXT NOT NULL,
  packed BLOB NOT NULL);

-- Enrolments under way: a row for every step and decision. The newest of a name is in force.
CREATE TABLE enrollment_drafts (
  id TEXT PRIMARY KEY, station TEXT NOT NULL, created_utc TEXT NOT NULL,
  type_name TEXT NOT NULL CHECK (type_name <> ''),
  state TEXT NOT NULL CHECK (state IN ('open', 'approved', 'discarded')),
  step TEXT NOT NULL CHECK (step IN ('recipe', 'squeeze', 'review')),
  recipe_name TEXT NOT NULL,
  peak_n DOUBLE PRECISION NOT NULL, bias_n DOUBLE PRECISION NOT NULL,
  bit_s DOUBLE PRECISION NOT NULL, seconds DOUBLE PRECISION NOT NULL,
  max_force_n DOUBLE PRECISION NOT NULL, max_travel_m DOUBLE PRECISION NOT NULL,
  part TEXT NOT NULL,
  picture_id TEXT REFERENCES pictures (id),
  pending_id TEXT REFERENCES draft_squeezes (id),
  remark TEXT NOT NULL, operator_name TEXT NOT NULL);
CREATE INDEX enrollment_drafts_of_name ON enrollment_drafts (type_name, id);
INSERT INTO enrollment_drafts VALUES ('e1', 'plant-1', '2024-09-30T12:02:00.000Z', 'Jar', 'open', 'squeeze', 'gentle', 11, 21, 0.005, 1, 40, 0.02, '', NULL, NULL, '', 'Ada');
