#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# The window under the address and undefined-behaviour sanitizers: every page at work and empty, every dialog, and all of
# them full of hostile names. Building the window so takes longer than a change may wait for, so this is for the night.
# Usage: packaging/sanitized_window.sh [TEST CLASS...]
set -euo pipefail
cd "$(dirname "$0")/.."
packaging/build.sh asan-window test_ui
# The libraries below (fontconfig, Mesa, VTK) keep caches until the end, which are no leaks of this program's.
export ASAN_OPTIONS=detect_leaks=0:halt_on_error=1 UBSAN_OPTIONS=halt_on_error=1:print_stacktrace=1
export QT_QPA_PLATFORM=offscreen
unset DISPLAY
[[ $# -gt 0 ]] || set -- LayoutTest DialogLayoutTest PlainTextTest
failed=0
for class in "$@"; do
  # The virtual gripper lives in this process: a heartbeat that is late because of the sanitizers is no finding.
  build/asan-window/bin/test_ui "$class" -maxwarnings 0 || failed=1
done
exit $failed
