#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Configures core and devices as for the sanitizers and looks whether each test class is registered there or left out with
# a reason; nothing is built. Usage: tests/support/sanitized_tests.sh CMAKE WORK_FOLDER
set -euo pipefail
cmake=${1:?the cmake to use} work=${2:?a folder to configure in}
root=$(cd "$(dirname "$0")/../.." && pwd)
rm -rf "$work"
trap 'rm -rf "$work"' EXIT
mkdir -p "$work"
"$cmake" -S "$root" -B "$work/build" -G Ninja -DGRIPSCOPE_UI=OFF -DGRIPSCOPE_SANITIZE=address,undefined >"$work/log" 2>&1 ||
  { cat "$work/log"; exit 1; }
"$root/tests/support/tests_ran.sh" "$work/build"
