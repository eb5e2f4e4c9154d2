#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Installs what is missing, builds, and opens Gripscope on the virtual gripper with four example types enrolled.
# Where there is no display it runs the demonstration on the command line instead.
set -euo pipefail
cd "$(dirname "$0")/.."
packaging/install_dependencies.sh build run
if [[ -n ${DISPLAY:-} || -n ${WAYLAND_DISPLAY:-} ]]; then
  packaging/build.sh release gripscope gripscope-cli
  exec build/release/bin/gripscope --examples --device virtual: "$@"
fi
packaging/build.sh release gripscope-cli
echo "There is no display here, so this is the demonstration on the command line (gripscope-cli demo):"
exec build/release/bin/gripscope-cli demo
