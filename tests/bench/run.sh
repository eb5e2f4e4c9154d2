#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Times the identification and, in the same run, the peers that are installed; prints the ratios for ARX (2,1,1).
#   tests/bench/run.sh [FOLDER OF identification_bench]      (built with -DGRIPSCOPE_BENCH=ON)
set -eu
here=$(dirname "$0")
bench=${1:-$here/../../build/dev/bin}/identification_bench
folder=$(mktemp -d)
trap 'rm -r "$folder"' EXIT
GRIPSCOPE_PEER_RECORD=$folder/record.csv "$bench" --benchmark_format=console --benchmark_out="$folder/bench.csv" \
  --benchmark_out_format=csv
python=$(command -v /usr/bin/python3 || command -v python3)
if "$python" -c 'import numpy' 2>/dev/null; then
  "$python" "$here/peers.py" "$folder/record.csv" >"$folder/peers"
  own=$(grep '^"arxCoefficients/2000"' "$folder/bench.csv" | cut -d, -f4)
  echo "ARX (2,1,1), 2,000 samples: Gripscope $own us"
  awk -v own="$own" '{printf "  %s %s us, %.1f times as long; a1 a2 b1: %s %s %s\n", $1, $2, $2 / own, $3, $4, $5}' "$folder/peers"
else
  echo "no numpy: peers not measured"
fi
