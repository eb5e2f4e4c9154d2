// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/migrations/migration.h"

namespace gripscope {

const char* const migrationScript4 = R"sql(
-- Versions of the library: one row for each change of what is recognised, with who, when and why.
CREATE TABLE library_changes (
  id TEXT PRIMARY KEY, station TEXT NOT NULL, changed_utc TEXT NOT NULL,
  version BIGINT NOT NULL UNIQUE CHECK (version >= 1),
  kind TEXT NOT NULL, type_name TEXT NOT NULL, other_name TEXT NOT NULL,
  squeezes INTEGER NOT NULL,
  operator_name TEXT NOT NULL, reason TEXT NOT NULL);

-- What a type is called and whether it is recognised, from a version of the library on.
-- types.name is only the first name it had, and need not be that.
CREATE TABLE type_states (
  id TEXT PRIMARY KEY, station TEXT NOT NULL, created_utc TEXT NOT NULL,
  type_id TEXT NOT NULL REFERENCES types (id),
  version BIGINT NOT NULL CHECK (version >= 0),
  name TEXT NOT NULL CHECK (name <> ''),
  status TEXT NOT NULL CHECK (status IN ('enrolled', 'approved', 'retired', 'gone')),
  recipe_version INTEGER NOT NULL,
  UNIQUE (type_id, version));

-- Where a squeeze of an enrolment belongs from a version on; before the first, to grasps.type_id.
CREATE TABLE placements (
  id TEXT PRIMARY KEY, station TEXT NOT NULL, created_utc TEXT NOT NULL,
  grasp_id TEXT NOT NULL REFERENCES grasps (id),
  version BIGINT NOT NULL CHECK (version >= 1),
  type_id TEXT NOT NULL REFERENCES types (id),
  accepted INTEGER NOT NULL CHECK (accepted IN (0, 1)),
  UNIQUE (grasp_id, version));
CREATE INDEX placements_of_type ON placements (type_id);

-- Which part was squeezed, as the operator calls it; and the version with which an enrolled squeeze came.
ALTER TABLE grasps ADD COLUMN part TEXT NOT NULL DEFAULT '';
ALTER TABLE grasps ADD COLUMN library_version BIGINT NOT NULL DEFAULT 0;

-- What was approved and dropped so far, in the same form.
INSERT INTO library_changes
SELECT e.id, e.station, e.utc, ROW_NUMBER() OVER (ORDER BY e.utc, e.id), e.kind, e.type_name, '', e.squeezes, e.operator_name, e.reason
FROM (SELECT a.id AS id, a.station AS station, a.approved_utc AS utc, 'approve' AS kind, t.name AS type_name,
    0 AS squeezes, a.operator_name AS operator_name, '' AS reason
  FROM approvals a JOIN types t ON t.id = a.type_id
  UNION ALL SELECT d.id, d.station, d.decided_utc, 'drop', COALESCE(t.name, ''), 1, d.operator_name, d.reason
  FROM decisions d JOIN grasps g ON g.id = d.grasp_id LEFT JOIN types t ON t.id = g.type_id) e;

INSERT INTO type_states
SELECT t.id, t.station, t.created_utc, t.id, 0, t.name, 'enrolled',
  (SELECT MAX(v.version) FROM type_versions v WHERE v.type_id = t.id)
FROM types t;

INSERT INTO type_states
SELECT a.id, a.station, a.approved_utc, a.type_id, c.version, t.name, 'approved',
  (SELECT MAX(v.version) FROM type_versions v WHERE v.type_id = t.id)
FROM approvals a JOIN library_changes c ON c.id = a.id JOIN types t ON t.id = a.type_id;

INSERT INTO placements
SELECT d.id, d.station, d.decided_utc, d.grasp_id, c.version, g.type_id, 0
FROM decisions d JOIN library_changes c ON c.id = d.id JOIN grasps g ON g.id = d.grasp_id
WHERE g.type_id IS NOT NULL;

DROP TABLE approvals;
DROP TABLE decisions;
)sql";

} // namespace gripscope
