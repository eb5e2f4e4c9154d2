#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Times K-means on a million items and, in the same run, scikit-learn where it is installed; prints the ratios.
#   tests/bench/kmeans_run.sh [FOLDER OF kmeans_peer_bench]      (built with -DGRIPSCOPE_BENCH=ON)
set -eu
here=$(dirname "$0")
bench=${1:-$here/../../build/dev/bin}/kmeans_peer_bench
folder=$(mktemp -d)
trap 'rm -r "$folder"' EXIT
GRIPSCOPE_PEER_FOLDER=$folder "$bench"
python=$(command -v /usr/bin/python3 || command -v python3)
if "$python" -c 'import sklearn' 2>/dev/null; then
  "$python" "$here/kmeans_peer.py" "$folder"
else
  echo "no scikit-learn: peer not measured"
fi
