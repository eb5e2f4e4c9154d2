#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Times the start of the desktop program: from the start of the process to the first picture of its window that ten
# others follow without a pause of more than 100 ms, so that it answers. Starts RUNS times (5), prints each.
#   tests/bench/start.sh [PROGRAM] [RUNS]
set -eu
program=${1:-$(dirname "$0")/../../build/dev/bin/gripscope}
folder=$(mktemp -d)
trap 'rm -r "$folder"' EXIT
export XDG_CONFIG_HOME="$folder" XDG_DATA_HOME="$folder" QT_LOGGING_RULES="qt.widgets.painting=true"
# By the clock on the wall: Qt counts the time of a process only from its first message on.
export QT_MESSAGE_PATTERN="%{time H m s.zzz} %{category} %{message}"
run=0
while [ "$run" -lt "${2:-5}" ]; do
  run=$((run + 1))
  # shellcheck disable=SC2016 # expanded by the inner shell
  timeout 10 xvfb-run -a -s "-screen 0 1600x1000x24" sh -c 'date "+%H %M %S.%3N started" >&2; exec "$0" --library "$1"' \
    "$program" "$folder/library.gripscope" 2>"$folder/log" || true
  awk '{ now = 3600 * $1 + 60 * $2 + $3 }
       $4 == "started" { start = now }
       /qt.widgets.painting Syncing dirty widgets/ {
         if (!n || now - last > 0.1) { begin = now; n = 0 }
         last = now
         if (++n == 10) { printf "%.3f s\n", begin - start; found = 1; exit }
       }
       END { if (!found) print "no window" }' "$folder/log"
done
