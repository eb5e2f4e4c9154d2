// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/migrations/migration.h"

namespace gripscope {

const char* const migrationScript16 = R"sql(
-- How many inspections of each kind there were up to a number: every some thousand, so that counting all is counting those
-- since. The rows of one up_to belong together, and hold all that were before it.
CREATE TABLE inspection_tallies (
  id TEXT PRIMARY KEY, station TEXT NOT NULL, created_utc TEXT NOT NULL,
  up_to BIGINT NOT NULL CHECK (up_to >= 1),
  verdict TEXT NOT NULL, expected_type TEXT NOT NULL, type_name TEXT NOT NULL,
  n BIGINT NOT NULL CHECK (n >= 1),
  UNIQUE (up_to, verdict, expected_type, type_name));

-- The recording of a squeeze that was kept before anybody decided on it is where it was kept; packed is empty then.
ALTER TABLE recordings ADD COLUMN draft_squeeze_id TEXT REFERENCES draft_squeezes (id);
)sql";

} // namespace gripscope
