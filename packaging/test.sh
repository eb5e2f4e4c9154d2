#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Installs what is missing, builds, and runs every test. Usage: packaging/test.sh [PRESET]   (default: release)
set -euo pipefail
cd "$(dirname "$0")/.."
preset=${1:-release}
packaging/install_dependencies.sh build run test
packaging/build.sh "$preset"
log=build/$preset/tests.log status=0
# Three, for many wait for a gripper most of their time.
ctest --preset "$preset" --parallel 3 2>&1 | tee "$log" || status=$?
# ctest is content with what was skipped and does not know what is not registered.
tests/support/tests_ran.sh "build/$preset" "$log" || status=$((status ? status : 1))
exit "$status"
