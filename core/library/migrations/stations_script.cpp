// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/migrations/migration.h"

namespace gripscope {

const char* const stationsScript = R"sql(
-- The ledgers of libraries that were merged into this one, as they are there. library: the first half of the hash of a
-- ledger's first link.
CREATE TABLE merged_ledger (
  library TEXT NOT NULL CHECK (library <> ''),
  chain TEXT NOT NULL CHECK (chain <> ''), number BIGINT NOT NULL CHECK (number >= 1),
  kind TEXT NOT NULL CHECK (kind IN ('written', 'found')),
  format INTEGER NOT NULL,
  created_utc TEXT NOT NULL,
  leaves {blob} NOT NULL,
  previous_hash {blob} NOT NULL, hash {blob} NOT NULL,
  signer {blob} NOT NULL, signature {blob} NOT NULL,
  PRIMARY KEY (library, chain, number));

-- How a row is in such a library, where it differs from the row here (content: a JSON object of these columns), or where it is
-- kept for the record alone (whole = 1: all columns). number: an inspection's, a version's or a recipe's there; is_origin: it
-- was made there.
CREATE TABLE merged_rows (
  library TEXT NOT NULL CHECK (library <> ''),
  table_code INTEGER NOT NULL, row_key TEXT NOT NULL,
  number BIGINT NOT NULL,
  is_origin INTEGER NOT NULL CHECK (is_origin IN (0, 1)),
  whole INTEGER NOT NULL CHECK (whole IN (0, 1)),
  content TEXT NOT NULL,
  PRIMARY KEY (library, table_code, row_key));
CREATE UNIQUE INDEX merged_rows_of_origin ON merged_rows (table_code, row_key) WHERE is_origin = 1;

-- Each time that another library was merged into this one: from which version here on changes are made knowing those of others
-- (seen: JSON, by library the newest version), and how far their ledgers went (heads: JSON, by library and chain).
CREATE TABLE library_meetings (
  id TEXT PRIMARY KEY, station TEXT NOT NULL, created_utc TEXT NOT NULL,
  library TEXT NOT NULL CHECK (library <> ''), version BIGINT NOT NULL CHECK (version >= 0),
  other TEXT NOT NULL CHECK (other <> ''), seen TEXT NOT NULL, heads TEXT NOT NULL,
  taken BIGINT NOT NULL CHECK (taken >= 0), operator_name TEXT NOT NULL);

-- What stations decided while apart, as somebody who may decide it has seen it.
CREATE TABLE conflicts_seen (
  id TEXT PRIMARY KEY, station TEXT NOT NULL, created_utc TEXT NOT NULL,
  conflict TEXT NOT NULL CHECK (conflict <> ''), operator_name TEXT NOT NULL);
)sql";

} // namespace gripscope
