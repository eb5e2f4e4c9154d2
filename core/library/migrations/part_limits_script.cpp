// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/migrations/migration.h"

namespace gripscope {

const char* const partLimitsScript = R"sql(
-- What m, b and k of the parts of a type may be, and by which rule that is decided: "k=11.5:12.5 rule=iso14253", in the
-- units that follow from the type's channels; empty: no limits.
ALTER TABLE type_states ADD COLUMN part_limits TEXT NOT NULL DEFAULT '';
-- How an inspected part stood to them, and by which values (JSON); empty: its type had none, or no type was recognised.
ALTER TABLE inspections ADD COLUMN conformity TEXT NOT NULL DEFAULT '';
ALTER TABLE inspections ADD COLUMN conformity_values TEXT NOT NULL DEFAULT '';
-- What is counted is told apart by it, too.
DROP INDEX inspections_of_batch;
DROP INDEX inspections_suspect;
DROP INDEX inspections_without_validity;
CREATE INDEX inspections_of_batch ON inspections (batch_id, verdict, expected_type, type_name, conformity);
CREATE INDEX inspections_suspect ON inspections (verdict, expected_type, type_name, conformity) WHERE validity = 'suspect';
CREATE INDEX inspections_without_validity ON inspections (verdict, expected_type, type_name, conformity)
  WHERE validity = '';
)sql";

} // namespace gripscope
