// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/migrations/migration.h"

namespace gripscope {

const char* const migrationScript3 = R"sql(
ALTER TABLE measuring_chains ADD COLUMN force_noise_deviation DOUBLE PRECISION NOT NULL DEFAULT 0;
)sql";

} // namespace gripscope
