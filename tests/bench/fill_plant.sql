-- SPDX-License-Identifier: GPL-3.0-or-later
-- After fill_server.sql: what else a server has of inspections that :stations stations brought, and of :changes changes
-- of types that each of them took: numbers of the stations, recordings (empty), documents, deliveries and meetings.
\set ON_ERROR_STOP on
SET session_replication_role = replica;
SET synchronous_commit = off;

CREATE FUNCTION pg_temp.key(i bigint, kind text) RETURNS text LANGUAGE sql AS $$
  SELECT overlay(md5(kind || i) placing lpad(to_hex(1704067200000 + 6000 * i), 12, '0') || '7' from 1)::uuid::text $$;
CREATE FUNCTION pg_temp.library(i bigint, stations bigint) RETURNS text LANGUAGE sql AS $$ SELECT md5('library ' || i % stations) $$;

INSERT INTO recordings (id, station, created_utc, grasp_id, samples, bytes, sha256, packed)
SELECT pg_temp.key(i, 'r'), '', '', pg_temp.key(i, 'g'), 0, 0, '', '' FROM generate_series(1, :inspections) AS i;
INSERT INTO documents (id, station, created_utc, grasp_id, document)
SELECT pg_temp.key(i, 'd'), '', '', pg_temp.key(i, 'g'), '{}' FROM generate_series(1, :inspections) AS i;
INSERT INTO merged_rows (library, table_code, row_key, number, is_origin, whole, content)
SELECT pg_temp.library(i, :stations), 13, pg_temp.key(i, 'i'), i / :stations, 1, 0, '{}' FROM generate_series(1, :inspections) AS i;

-- A delivery of four inspections each.
INSERT INTO library_meetings (id, station, created_utc, library, version, other, seen, heads, taken, operator_name)
SELECT pg_temp.key(i, 'm'), '', '', 'server', i * :changes / (:inspections / 4), pg_temp.library(i, :stations), '{}',
       '{"' || pg_temp.library(i, :stations) || ' hall-1/0123456789abcdef":"' || i || ' ' || md5(i::text) || md5(i::text) || '"}', 20, ''
FROM generate_series(1, :inspections / 4) AS i;
-- Each change is taken by each station, which has seen another version of one library then.
INSERT INTO merged_rows (library, table_code, row_key, number, is_origin, whole, content)
SELECT pg_temp.library(s, :stations), 70, pg_temp.key(i * :stations + s, 't'), 0, 0, 1,
       '{"created_utc":"2024-01-01T00:00:00.000Z","heads":"{}","id":"","library":"' || pg_temp.library(s, :stations) ||
       '","operator_name":"","other":"server","seen":"{\"' || pg_temp.library(i, :stations) || '\":' || i || '}","station":"hall-1","taken":3,"version":' || i || '}'
FROM generate_series(1, :changes) AS i, generate_series(0, :stations - 1) AS s;
VACUUM (ANALYZE) recordings, documents, merged_rows, library_meetings;
