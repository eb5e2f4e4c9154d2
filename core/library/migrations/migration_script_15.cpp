// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/migrations/migration.h"

namespace gripscope {

const char* const migrationScript15 = R"sql(
-- Inspections that do not count: squeezed twice, or with nothing in the jaws. Their rows stay as they were written.
CREATE TABLE inspection_voids (
  id TEXT PRIMARY KEY, station TEXT NOT NULL, voided_utc TEXT NOT NULL,
  inspection_id TEXT NOT NULL UNIQUE REFERENCES inspections (id),
  operator_name TEXT NOT NULL,
  reason TEXT NOT NULL CHECK (reason <> ''));

-- What a scanner read on the part; empty: nothing.
ALTER TABLE inspections ADD COLUMN part_number TEXT NOT NULL DEFAULT '';
)sql";

} // namespace gripscope
