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
export QT_MESSAGE_PATTERN="%{time process} %{category} %{message}"
run=0
while [ "$run" -lt "${2:-5}" ]; do
  run=$((run + 1))
  timeout 10 xvfb-run -a -s "-screen 0 1600x1000x24" "$program" --library "$folder/library.gripscope" 2>"$folder/log" || true
  awk '/qt.widgets.painting Syncing dirty widgets/ {
         if (!n || $1 - last > 0.1) { begin = $1; n = 0 }
         last = $1
         if (++n == 10) { printf "%.3f s\n", begin; found = 1; exit }
       }
       END { if (!found) print "no window" }' "$folder/log"
done
