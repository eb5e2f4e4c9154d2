#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Says whether every file's licence and copyright are known (reuse lint), and writes the list of all files with theirs as an
# SPDX document. Usage: packaging/licences.sh [FOLDER]   (writes FOLDER/gripscope.spdx; without it, lint only)
# reuse looks for licence texts in LICENSES at the top, a place the repository does not have: it sees a copy that has it.
set -euo pipefail
cd "$(dirname "$0")/.."
copy=$(mktemp -d)
trap 'rm -rf "$copy"' EXIT
git ls-files -z --cached --others --exclude-standard | xargs -0 cp --parents -t "$copy"
mkdir "$copy/LICENSES"
mv "$copy/LICENSE" "$copy/LICENSES/GPL-3.0-or-later.txt"
mv "$copy"/.reuse/licences/* "$copy/LICENSES/"
rmdir "$copy/.reuse/licences"
reuse --root "$copy" lint
[[ -n ${1:-} ]] || exit 0
mkdir -p "$1"
reuse --root "$copy" spdx -o "$1/gripscope.spdx"
# The same tree gives the same bytes: a date that is asked for, and a name made of what is listed.
date=$(date -u -d "@${SOURCE_DATE_EPOCH:-0}" +%Y-%m-%dT%H:%M:%SZ)
version=$(sed -nE 's/^project\(Gripscope VERSION ([0-9.]+).*/\1/p' CMakeLists.txt)
sum=$(grep -vE '^(Created|DocumentNamespace|DocumentName): ' "$1/gripscope.spdx" | sha256sum | cut -c 1-32)
sed -i -E "s|^Created: .*|Created: $date|; s|^DocumentName: .*|DocumentName: gripscope-$version|
  s|^Creator: Organization: .*|Creator: Organization: The Gripscope contributors ()|; /^Creator: Person: Anonymous/d
  s|^DocumentNamespace: .*|DocumentNamespace: https://gripscope.org/spdx/gripscope-$version-$sum|" "$1/gripscope.spdx"
