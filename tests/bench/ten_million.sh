#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Fills a library on a PostgreSQL server of its own with ten million inspections, and says how large it is and how
# long the history and the charts take; it takes 30 GB under /tmp and half an hour, and leaves nothing behind.
#   tests/bench/ten_million.sh [INSPECTIONS [FOLDER OF history_bench, process_bench, gripscope-cli]]
#                                                                (built with -DGRIPSCOPE_BENCH=ON)
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
inspections=${1:-10000000}
programs=${2:-$here/../../build/dev/bin}

if [ -z "${GRIPSCOPE_TEST_SERVER:-}" ]; then
  # As a server of 8 GB would be set, but for what a power cut would take.
  GRIPSCOPE_SERVER_SETTINGS="-c shared_buffers=1GB -c effective_cache_size=6GB -c work_mem=32MB -c random_page_cost=1.1
    -c max_wal_size=8GB -c wal_level=minimal -c max_wal_senders=0" \
    exec "$here/../support/postgresql.sh" run "$0" "$inspections" "$programs"
fi

psql -q "$GRIPSCOPE_TEST_SERVER" -c 'CREATE DATABASE filled TEMPLATE template0'
export GRIPSCOPE_BENCH_LIBRARY=${GRIPSCOPE_TEST_SERVER/\/postgres\?//filled?}
"$programs/gripscope-cli" types list --library "$GRIPSCOPE_BENCH_LIBRARY" >/dev/null # makes the tables
psql -q -v inspections="$inspections" -f "$here/fill_server.sql" "$GRIPSCOPE_BENCH_LIBRARY"

times() {
  "$programs/$1" --benchmark_min_time=0.001 --benchmark_repetitions=5 --benchmark_report_aggregates_only=true 2>/dev/null |
    sed -n 's/_median//p' | sed 's,/process_time,,; s,/real_time,,'
}
uptime
times history_bench # which stores some inspections with recordings
times process_bench
uptime
psql -v ON_ERROR_STOP=1 "$GRIPSCOPE_BENCH_LIBRARY" <<'SQL'
SELECT relname AS "table", pg_relation_size(c.oid) / 1000000 AS "rows, MB", pg_indexes_size(c.oid) / 1000000 AS "indexes, MB",
       pg_total_relation_size(c.oid) / (SELECT COUNT(*) FROM inspections) AS "bytes an inspection"
FROM pg_class c WHERE relname IN ('grasps', 'estimates', 'inspections');
SELECT c.relname AS "index", pg_relation_size(indexrelid) / 1000000 AS "MB" FROM pg_stat_user_indexes i
JOIN pg_class c ON c.oid = i.indexrelid ORDER BY 2 DESC LIMIT 30;
SELECT pg_database_size(current_database()) / 1000000 AS "all, MB";
SELECT AVG(pg_column_size(packed))::int AS "bytes a recording of 2,000 samples" FROM recordings;
SELECT AVG(pg_column_size(l.*))::int AS "bytes a link of the ledger" FROM ledger l;
SQL
