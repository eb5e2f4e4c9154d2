// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/migrations/migration.h"

namespace gripscope {

const char* const migrationScript20 = R"sql(
-- How the force of a squeeze goes: "prbs" (two levels, as all before), "four-level", "inverse-repeat", "multisine".
ALTER TABLE type_versions ADD COLUMN force_kind TEXT NOT NULL DEFAULT 'prbs';
ALTER TABLE enrollment_drafts ADD COLUMN force_kind TEXT NOT NULL DEFAULT 'prbs';
)sql";

} // namespace gripscope
