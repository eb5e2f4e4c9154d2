#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# clang-tidy over core and devices, over those of their files that the last commits changed (--recent), or over the files
# named.
set -euo pipefail
cd "$(dirname "$0")/.."
# A build folder of its own, configured but not built, except for what protoc makes: clang-tidy cannot read GCC's precompiled
# headers, and core and devices have no other generated code.
cmake -S . -B build/tidy -G Ninja -DCMAKE_BUILD_TYPE=Release -DGRIPSCOPE_UI=OFF -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON >/dev/null
cmake --build build/tidy --target sparkplug_b >/dev/null
if [[ $# -eq 0 ]]; then
  mapfile -t files < <(git ls-files 'core/*.cpp' 'devices/*.cpp')
elif [[ $1 == --recent ]]; then
  # Reading the templates takes seconds a file: all of them would take CI too long, and a change of many files counts by its
  # newest.
  mapfile -t files < <(git log -n 20 --format= --name-only --diff-filter=AM -- 'core/*.cpp' 'devices/*.cpp' |
    awk '!seen[$0]++' | while read -r file; do [[ -e $file ]] && echo "$file"; done | head -n 12)
else
  files=("$@")
fi
printf '%s\0' "${files[@]}" |
  xargs -0 -r -n 1 -P "$(nproc)" clang-tidy -p build/tidy --quiet --extra-arg=-Wno-unknown-warning-option 2>/dev/null
echo "clang-tidy: ${#files[@]} files, nothing found"
