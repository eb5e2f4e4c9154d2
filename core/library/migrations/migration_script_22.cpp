// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/migrations/migration.h"

namespace gripscope {

const char* const migrationScript22 = R"sql(
-- What a squeeze determines besides m, b and k, or in their place: the quantities ("m+b+k+k1/k+tau"), their natural
-- logarithms in SI where the channels' units are known (tau in seconds), and the upper triangle of the covariance, row by
-- row; empty: not known. Squeezes that determine m, b and k alone have no row.
CREATE TABLE determined_quantities (
  id TEXT PRIMARY KEY, station TEXT NOT NULL, created_utc TEXT NOT NULL,
  grasp_id TEXT NOT NULL UNIQUE REFERENCES grasps (id),
  quantities TEXT NOT NULL CHECK (quantities <> ''),
  logarithms TEXT NOT NULL, covariance TEXT NOT NULL);
)sql";

} // namespace gripscope
