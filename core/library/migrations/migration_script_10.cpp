// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/migrations/migration.h"

namespace gripscope {

const char* const migrationScript10 = R"sql(
-- People: the newest version of a person is in force; nobody is deleted. secret_hash: argon2id with its salt.
CREATE TABLE people (
  id TEXT PRIMARY KEY, station TEXT NOT NULL, created_utc TEXT NOT NULL,
  person_id TEXT NOT NULL, version INTEGER NOT NULL CHECK (version >= 1),
  name TEXT NOT NULL CHECK (name <> ''),
  role TEXT NOT NULL CHECK (role IN ('operator', 'supervisor')),
  active INTEGER NOT NULL CHECK (active IN (0, 1)),
  secret_hash TEXT NOT NULL, secret_version INTEGER NOT NULL,
  UNIQUE (person_id, version));

-- Tries to sign in. 'tried' is written before the secret is looked at, so that a process that is ended then has
-- not won a try; 'right' when it was.
CREATE TABLE sign_in_tries (
  id TEXT PRIMARY KEY, station TEXT NOT NULL, created_utc TEXT NOT NULL,
  person_id TEXT NOT NULL, secret_version INTEGER NOT NULL,
  outcome TEXT NOT NULL CHECK (outcome IN ('tried', 'right')));
CREATE INDEX sign_in_tries_of_person ON sign_in_tries (person_id, created_utc, id);

-- Who did what, when and why; each row carries the hash of the one before.
CREATE TABLE audit_entries (
  number BIGINT PRIMARY KEY CHECK (number >= 1),
  station TEXT NOT NULL, created_utc TEXT NOT NULL,
  person TEXT NOT NULL, role TEXT NOT NULL, action TEXT NOT NULL, subject TEXT NOT NULL, reason TEXT NOT NULL,
  details TEXT NOT NULL, previous_hash TEXT NOT NULL, hash TEXT NOT NULL);
)sql";

} // namespace gripscope
