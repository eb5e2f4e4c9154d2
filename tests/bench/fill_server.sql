-- SPDX-License-Identifier: GPL-3.0-or-later
-- Fills an empty library on a server with :inspections inspections, as 8 stations would have stored them six
-- seconds apart: keys in order of time, half of them of "Type 01", the rest of eleven others; 1 % unknown, 2 %
-- another type, 1 % inconclusive or not valid, 1 % suspect; six operators, eight grippers, a batch of 5,000 and
-- a part number each. Recordings, documents and the ledger are left out: no list and no chart reads them. Run by
-- psql as a superuser of a server with nothing else on it.
\set ON_ERROR_STOP on
SET session_replication_role = replica; -- no foreign key is looked up
SET synchronous_commit = off;
SET maintenance_work_mem = '1GB';

-- Of one expression each, so that they cost no call.
CREATE FUNCTION pg_temp.key(i bigint, kind text) RETURNS text LANGUAGE sql AS $$
  SELECT overlay(md5(kind || i) placing lpad(to_hex(1704067200000 + 6000 * i), 12, '0') || '7' from 1)::uuid::text $$;
CREATE FUNCTION pg_temp.time(i bigint) RETURNS text LANGUAGE sql AS $$
  SELECT to_char(timestamp '2024-01-01' + i * interval '6 seconds', 'YYYY-MM-DD"T"HH24:MI:SS.MS"Z"') $$;
CREATE FUNCTION pg_temp.type(i bigint) RETURNS text LANGUAGE sql AS $$
  SELECT CASE WHEN i % 2 = 0 THEN 'Type 01' ELSE 'Type ' || lpad((2 + i / 2 % 11)::text, 2, '0') END $$;

-- Made anew at the end, which takes a tenth of the time.
CREATE TEMP TABLE left_out AS SELECT x.indexrelid::regclass::text AS name, pg_get_indexdef(x.indexrelid) AS made
  FROM pg_index x WHERE x.indrelid IN ('grasps'::regclass, 'estimates'::regclass, 'inspections'::regclass)
  AND NOT EXISTS (SELECT FROM pg_constraint c WHERE c.conindid = x.indexrelid);
SELECT 'DROP INDEX ' || name FROM left_out \gexec

INSERT INTO batches (id, station, begun_utc, name, target, expected_type, operator_name)
SELECT pg_temp.key(i * 5000, 'b'), 'hall-' || i % 8, pg_temp.time(i * 5000), 'L' || 100000 + i, 5000, '', 'Operator ' || i % 6
FROM generate_series(0, :inspections / 5000) AS i;

INSERT INTO grasps (id, station, recorded_utc, operator_name, source, force_unit, position_unit, device_name,
                    device_serial, firmware, library_version, utc_offset_s)
SELECT pg_temp.key(i, 'g'), 'hall-' || i % 8, pg_temp.time(i), 'Operator ' || i / 5000 % 6, 'hid:', 'N', 'm',
       'Gripper', 'G000' || i % 8, '1.4.2', 12, 3600
FROM generate_series(1, :inspections) AS i;

INSERT INTO estimates (id, station, created_utc, grasp_id, rank, estimator, status, message, program, m, b, k, var_m,
                       cov_mb, cov_mk, var_b, cov_bk, var_k, x0, v0, position_offset, simulation_fit_percent,
                       prediction_fit_percent, sse, degrees_of_freedom, whiteness_p, input_independence_p, iterations)
SELECT pg_temp.key(i, 'e'), 'hall-' || i % 8, pg_temp.time(i), pg_temp.key(i, 'g'), 0, 'oe', 'converged', '', '1.0',
       0.04 + 1e-4 * (random() + random() - 1), 43 + 0.1 * (random() + random() - 1),
       9990 + 20 * (random() + random() - 1), 1e-8, 1e-6, 1e-5, 0.01, 0.1, 100, 1e-6, 1e-4, 1e-7, 90 + 8 * random(),
       99, 1e-9 * random(), 1994, random(), random(), 8
FROM generate_series(1, :inspections) AS i;

INSERT INTO inspections (id, station, inspected_utc, number, grasp_id, expected_type, verdict, type_name, nearest,
                         posterior, distance, gate, samples_used, false_reject, wrong_type, seconds, operator_name,
                         posteriors, reasons, batch_id, validity, confidence, library_version, program, part_number)
SELECT pg_temp.key(i, 'i'), 'hall-' || i % 8, pg_temp.time(i), i, pg_temp.key(i, 'g'), pg_temp.type(i), verdict,
       CASE WHEN verdict <> 'type' THEN '' WHEN share < 30 THEN pg_temp.type(i + 1) ELSE pg_temp.type(i) END,
       pg_temp.type(i), 0.999, 3 * random(), 14.25, 2000, 0.01, 0.001, 1.2, 'Operator ' || i / 5000 % 6,
       '{"Type 01":0.9985317,"Type 02":0.0007341,"Type 03":0.0007342}', '[]', pg_temp.key(i / 5000 * 5000, 'b'),
       CASE WHEN verdict = 'invalid' THEN 'invalid' WHEN share BETWEEN 40 AND 49 THEN 'suspect' ELSE 'valid' END,
       0.95, 12, '1.0', 'P' || lpad(i::text, 9, '0')
FROM (SELECT i, share, CASE WHEN share < 10 THEN 'unknown' WHEN share BETWEEN 30 AND 34 THEN 'inconclusive'
                            WHEN share BETWEEN 35 AND 39 THEN 'invalid' ELSE 'type' END AS verdict
      FROM (SELECT i, i * 2654435761 / 65536 % 1000 AS share FROM generate_series(1, :inspections::bigint) AS i) AS drawn) AS judged;

SELECT made FROM left_out \gexec
DROP TABLE left_out;
VACUUM (ANALYZE) grasps, estimates, inspections, batches;
