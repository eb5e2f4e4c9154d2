// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/migrations/migration.h"

namespace gripscope {

const char* const migrationScript17 = R"sql(
-- What a certificate says. certificate_number: 1, 2, 3... at a station; 0: from before there were numbers.
-- load_unit: '' for the channel's quantity, 'kg' or 'lb' for masses, taken for forces by gravity (m/s2).
-- tolerance in the channel's unit; NULL: none. found_correction: what corrected the channel until then, '' for its own scale,
-- NULL: not recorded. check_points: as points, taken afterwards and not fitted. reference_due: YYYY-MM-DD or ''.
ALTER TABLE calibrations ADD COLUMN certificate_number BIGINT NOT NULL DEFAULT 0;
ALTER TABLE calibrations ADD COLUMN load_unit TEXT NOT NULL DEFAULT '';
ALTER TABLE calibrations ADD COLUMN gravity DOUBLE PRECISION;
ALTER TABLE calibrations ADD COLUMN ambient_celsius DOUBLE PRECISION;
ALTER TABLE calibrations ADD COLUMN tolerance DOUBLE PRECISION;
ALTER TABLE calibrations ADD COLUMN decision_rule TEXT NOT NULL DEFAULT 'guarded';
ALTER TABLE calibrations ADD COLUMN reference_due TEXT NOT NULL DEFAULT '';
ALTER TABLE calibrations ADD COLUMN found_correction TEXT;
ALTER TABLE calibrations ADD COLUMN check_points TEXT NOT NULL DEFAULT '';
CREATE UNIQUE INDEX certificates_of_station ON calibrations (station, certificate_number) WHERE certificate_number > 0;
)sql";

} // namespace gripscope
