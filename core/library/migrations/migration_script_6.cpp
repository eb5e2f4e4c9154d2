// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/migrations/migration.h"

namespace gripscope {

const char* const migrationScript6 = R"sql(
-- Pictures of parts, as PNG or JPEG.
CREATE TABLE pictures (
  id TEXT PRIMARY KEY, station TEXT NOT NULL, created_utc TEXT NOT NULL,
  format TEXT NOT NULL CHECK (format IN ('png', 'jpeg')),
  width INTEGER NOT NULL, height INTEGER NOT NULL,
  sha256 TEXT NOT NULL,
  bytes {blob} NOT NULL);

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
  packed {blob} NOT NULL);

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
)sql";

} // namespace gripscope
