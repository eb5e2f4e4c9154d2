// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/migrations/migration.h"

namespace gripscope {

const char* const migrationScript21 = R"sql(
-- Coulomb friction of the empty gripper itself, in the unit of its force channel. NULL: nobody measured it.
ALTER TABLE measuring_chains ADD COLUMN friction DOUBLE PRECISION;
ALTER TABLE measuring_chains ADD COLUMN friction_error DOUBLE PRECISION;
)sql";

} // namespace gripscope
