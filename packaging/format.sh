#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Formats every source file; with --check only says which are not formatted, or over 500 lines, and fails.
set -euo pipefail
cd "$(dirname "$0")/.."
sources() { git ls-files -z --cached --others --exclude-standard '*.cpp' '*.h'; }
if [[ ${1:-} != --check ]]; then
  sources | xargs -0 clang-format -i
  exit
fi
sources | xargs -0 clang-format --dry-run --Werror
echo "$(sources | tr '\0' '\n' | wc -l) files are formatted"
long=$(sources | xargs -0 wc -l | awk '$2 != "total" && $1 > 500')
[[ -z $long ]] || { echo "files over 500 lines:"; echo "$long"; exit 1; }
