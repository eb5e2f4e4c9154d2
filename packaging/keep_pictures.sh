#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Makes the kept pictures of all pages anew: the manual's (light, both languages) and those that the tests compare with (dark,
# high contrast). Look at each before you commit it. Usage: packaging/keep_pictures.sh [BUILD_FOLDER] (default build/release)
set -euo pipefail
cd "$(dirname "$0")/.."
program=${1:-build/release}/bin/gripscope
picture() { xvfb-run -a -s "-screen 0 1600x1000x24" "$program" --tour "$1" --theme "$2" --size 1024x640 \
  --language "${3:-en}"; }
picture resources/manual/pictures light
picture resources/manual/de/pictures light de
picture tests/data/pictures/dark dark
picture tests/data/pictures/contrast contrast
