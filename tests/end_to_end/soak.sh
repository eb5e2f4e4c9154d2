#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Virtual grippers with random faults, one after another. Usage: tests/end_to_end/soak.sh [--minutes N] [BUILD_FOLDER]
# (default: 2 minutes, build/release; before a release: 480)
set -euo pipefail
cd "$(dirname "$0")/../.."
minutes=2
if [[ ${1:-} == --minutes ]]; then minutes=$2; shift 2; fi
build=${1:-build/release}
cmake --build "$build" --target soak_check
"$build/bin/soak_check" "$minutes"
