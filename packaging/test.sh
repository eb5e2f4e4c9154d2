#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Installs what is missing, builds, and runs every test. Usage: packaging/test.sh [PRESET]   (default: release)
set -euo pipefail
cd "$(dirname "$0")/.."
preset=${1:-release}
packaging/install_dependencies.sh build run test
packaging/build.sh "$preset"
ctest --preset "$preset" --parallel 2
