#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# How long a change of a type takes to the server and to another station, with so many inspections, changes and stations
# on the server; and a step with nothing new.
#   tests/bench/plant_exchange.sh [INSPECTIONS [CHANGES [STATIONS [FOLDER OF gripscope-cli]]]]
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
inspections=${1:-1000000} changes=${2:-2000} stations=${3:-50}
programs=${4:-$here/../../build/dev/bin}

if [ -z "${GRIPSCOPE_TEST_SERVER:-}" ]; then
  GRIPSCOPE_SERVER_SETTINGS="-c shared_buffers=1GB -c effective_cache_size=6GB -c work_mem=32MB -c random_page_cost=1.1
    -c max_wal_size=8GB -c wal_level=minimal -c max_wal_senders=0" \
    exec "$here/../support/postgresql.sh" run "$0" "$inspections" "$changes" "$stations" "$programs"
fi

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
export XDG_DATA_HOME=$folder/data XDG_CONFIG_HOME=$folder/config
gripscope() { "$programs/gripscope-cli" "$@" >"$folder/said" 2>&1 || { cat "$folder/said" >&2; exit 1; }; }
in_step() { # FILE WHAT
  local begun=$EPOCHREALTIME
  gripscope library sync --server "$server" --library "$folder/$1.db"
  awk -v begun="$begun" -v ended="$EPOCHREALTIME" -v what="$2" 'BEGIN { printf "%-52s %6.2f s\n", what, ended - begun }'
}

psql -q "$GRIPSCOPE_TEST_SERVER" -c 'CREATE DATABASE filled TEMPLATE template0'
server=${GRIPSCOPE_TEST_SERVER/\/postgres\?//filled?}
gripscope types list --library "$server" # makes the tables
psql -q -v inspections="$inspections" -f "$here/fill_server.sql" "$server"
psql -q -v inspections="$inspections" -v changes="$changes" -v stations="$stations" -f "$here/fill_plant.sql" "$server"
for station in one two; do gripscope library examples --library "$folder/$station.db"; done
in_step one "a station with four types comes"
in_step two "another with the same types comes"
for turn in 1 2 3; do
  gripscope types rename --type "${name:-A}" --to "Name $turn" --library "$folder/one.db" --reason bench
  name="Name $turn"
  in_step one "a change of a type is brought"
  in_step two "the other station takes it"
  in_step one "nothing new"
done
