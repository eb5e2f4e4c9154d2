// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/migrations/migration.h"

namespace gripscope {

const char* const migrationScript23 = R"sql(
-- The levels of a force of kind "levels", in parts of the peak about the preload: numbers with spaces between them.
ALTER TABLE type_versions ADD COLUMN force_levels TEXT NOT NULL DEFAULT '';
ALTER TABLE enrollment_drafts ADD COLUMN force_levels TEXT NOT NULL DEFAULT '';
)sql";

} // namespace gripscope
