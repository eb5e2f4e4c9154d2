// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/migrations/migration.h"

namespace gripscope {

const char* const migrationScript12 = R"sql(
-- The proof that rows are as they were written: a chain of links for each station, one link a transaction. leaves: of each
-- row its table, its key and its SHA-256. Rows that were there before it are in links of the kind 'found'.
CREATE TABLE ledger (
  chain TEXT NOT NULL CHECK (chain <> ''), number BIGINT NOT NULL CHECK (number >= 1),
  kind TEXT NOT NULL CHECK (kind IN ('written', 'found')),
  format INTEGER NOT NULL,
  created_utc TEXT NOT NULL,
  leaves {blob} NOT NULL,
  previous_hash {blob} NOT NULL, hash {blob} NOT NULL,
  signer {blob} NOT NULL, signature {blob} NOT NULL,
  PRIMARY KEY (chain, number));

-- The place of a row in the order they came, whatever the clock said.
ALTER TABLE measuring_chains ADD COLUMN serial BIGINT NOT NULL DEFAULT 0;
CREATE INDEX measuring_chains_in_order ON measuring_chains (serial);
ALTER TABLE calibrations ADD COLUMN serial BIGINT NOT NULL DEFAULT 0;
CREATE INDEX calibrations_in_order ON calibrations (serial);
ALTER TABLE reference_objects ADD COLUMN serial BIGINT NOT NULL DEFAULT 0;
CREATE INDEX reference_objects_in_order ON reference_objects (serial);
ALTER TABLE reference_checks ADD COLUMN serial BIGINT NOT NULL DEFAULT 0;
CREATE INDEX reference_checks_in_order ON reference_checks (serial);
ALTER TABLE enrollment_drafts ADD COLUMN serial BIGINT NOT NULL DEFAULT 0;
CREATE INDEX enrollment_drafts_in_order ON enrollment_drafts (serial);
ALTER TABLE type_pictures ADD COLUMN serial BIGINT NOT NULL DEFAULT 0;
CREATE INDEX type_pictures_in_order ON type_pictures (serial);
ALTER TABLE sign_in_tries ADD COLUMN serial BIGINT NOT NULL DEFAULT 0;
CREATE INDEX sign_in_tries_in_order ON sign_in_tries (serial);

-- The document of a squeeze, deflated; document is empty then.
ALTER TABLE documents ADD COLUMN packed {blob};

-- What the measurement behind a verdict is worth: valid, suspect, invalid. Empty in rows from before: it is in the
-- document then.
ALTER TABLE inspections ADD COLUMN validity TEXT NOT NULL DEFAULT '';
)sql";

} // namespace gripscope
