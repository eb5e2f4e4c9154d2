// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/migrations/migration.h"

namespace gripscope {

const char* const migrationScript18 = R"sql(
-- What the history is found by among millions: about 200 bytes an inspection. With the time where a filter is common and
-- its newest come first; without where all that a search finds are put in order afterwards.
CREATE INDEX grasps_by_operator ON grasps (operator_name, recorded_utc, id);
CREATE INDEX grasps_by_device ON grasps ((TRIM(device_name || ' ' || device_serial)), recorded_utc, id);
CREATE INDEX grasps_by_source ON grasps (source);
CREATE INDEX grasps_by_part ON grasps (part) WHERE part <> '';
CREATE INDEX inspections_by_type ON inspections (type_name);
CREATE INDEX inspections_by_expected ON inspections (expected_type);
CREATE INDEX inspections_by_part_number ON inspections (part_number) WHERE part_number <> '';

-- What the tallies do not know: which inspections are suspect, and those of before the column, whose documents tell.
CREATE INDEX inspections_suspect ON inspections (verdict, expected_type, type_name) WHERE validity = 'suspect';
CREATE INDEX inspections_without_validity ON inspections (verdict, expected_type, type_name) WHERE validity = '';
)sql";

} // namespace gripscope
