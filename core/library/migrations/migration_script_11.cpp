// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/migrations/migration.h"

namespace gripscope {

const char* const migrationScript11 = R"sql(
-- What a supervisor decided for all who work with this library: the newest version of a policy is in force.
CREATE TABLE policies (
  id TEXT PRIMARY KEY, station TEXT NOT NULL, created_utc TEXT NOT NULL,
  name TEXT NOT NULL, version INTEGER NOT NULL CHECK (version >= 1),
  value TEXT NOT NULL,
  UNIQUE (name, version));
)sql";

} // namespace gripscope
