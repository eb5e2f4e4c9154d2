#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Configures and builds one preset. Usage: packaging/build.sh PRESET [TARGET...]
set -euo pipefail
cd "$(dirname "$0")/.."
preset=${1:?a preset of CMakePresets.json}
shift
# Always, for it takes a second: what was installed since is seen (the display that scene tests start, the mocked devices).
log=$(mktemp)
trap 'rm -f "$log"' EXIT
cmake --preset "$preset" >"$log" 2>&1 || { tail -n 40 "$log" >&2; exit 1; }
cmake --build --preset "$preset" ${1:+--target "$@"}
