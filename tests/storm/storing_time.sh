#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# How long storing takes at a station alone, with its plant's server, and with that server gone: the three in turn, since a
# computer is not as busy all the time. Prints median, p99 and the greatest of each, in milliseconds, and p99 as a ratio.
# Usage: tests/storm/storing_time.sh BIN [ROUNDS [STORED_A_ROUND]]    (BIN: build/release/bin)
set -euo pipefail
bin=${1:?the folder of storm_station}
rounds=${2:-5} count=${3:-400}
here=$(cd "$(dirname "$0")" && pwd)
period_ms=50
work=$(mktemp -d)
trap '"$here/../support/postgresql.sh" stop "$work/address" || true; rm -rf "$work"' EXIT
"$here/../support/postgresql.sh" start "$work/address"
server=$(cat "$work/address")

# one NAME FILE SERVER: appends the microseconds of so many to NAME.
one() {
  mkfifo "$work/input"
  sleep infinity >"$work/input" &
  local writer=$!
  "$bin/storm_station" "$work/$2.db" "$3" "$period_ms" 1 <"$work/input" |
    awk -v count="$count" '$1 == "stored" { print $3; if (++n == count) exit }' >>"$work/$1.times" || true
  kill "$writer"
  wait "$writer" 2>/dev/null || true
  rm "$work/input"
}

for ((i = 0; i < rounds; ++i)); do
  # Each behind the same pause: what a server writes as it ends is on the same disk here.
  sleep 3
  one alone alone -
  sleep 3
  one linked linked "$server"
  "$here/../support/postgresql.sh" halt "$work/address"
  sleep 3
  one gone linked "$server" # a station that was in step, and counts what waits
  "$here/../support/postgresql.sh" go "$work/address"
done
for name in alone linked gone; do
  sort -n "$work/$name.times" | awk -v name="$name" '
    { t[NR] = $1 / 1000 }
    END { printf "%s %.2f %.2f %.2f %d\n", name, t[int((NR + 1) / 2)], t[int(NR * 0.99)], t[NR], NR }'
done | awk 'NR == 1 { alone = $3; print "which  median_ms  p99_ms  greatest_ms  stored  p99_to_alone" }
  { printf "%-7s %8.2f %8.2f %8.2f %8d %8.2f\n", $1, $2, $3, $4, $5, $3 / alone }'
