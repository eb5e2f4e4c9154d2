#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Feeds the parsers of device bytes with bytes that a fuzzer makes up, under the address and undefined-behaviour
# sanitizers. Builds what it needs with clang. Usage: tests/fuzz/run.sh [--seconds 60 | --runs N] [--keep]
#   --seconds  for all targets together          --runs  for each target
#   --keep     what reached new code is kept in tests/fuzz/corpus, the least set of inputs that reaches as much
# Exit: 0 nothing found; 1 a finding (its input is named); 77 there is no clang or libFuzzer here.
set -euo pipefail
cd "$(dirname "$0")/../.."
seconds=60 runs= keep=
while [[ $# -gt 0 ]]; do
  case $1 in
    --seconds) seconds=${2:?seconds}; shift 2 ;;
    --runs) runs=${2:?runs}; shift 2 ;;
    --keep) keep=1; shift ;;
    *) sed -n '3,7p' "$0" >&2; exit 2 ;;
  esac
done
command -v clang++ >/dev/null && compgen -G "$(clang++ -print-resource-dir)/lib/linux/libclang_rt.fuzzer-*" >/dev/null ||
  { echo "no clang with libFuzzer here (Debian: clang, libclang-rt-14-dev): not fuzzed"; exit 77; }

targets=()
for source in tests/fuzz/*_fuzz.cpp; do targets+=("$(basename "$source" .cpp)"); done
packaging/build.sh fuzz "${targets[@]}" >build/fuzz.log 2>&1 || { tail -n 40 build/fuzz.log >&2; exit 1; }
limit=(${runs:+"-runs=$runs"})
[[ -n $runs ]] || limit=("-max_total_time=$((seconds / ${#targets[@]}))")
for target in "${targets[@]}"; do
  kept=tests/fuzz/corpus/${target%_fuzz} found=build/fuzz/found/$target log=build/fuzz/$target.log
  mkdir -p "$kept" "$found"
  # New inputs go to the first folder; the kept ones are only read.
  if ! build/fuzz/bin/"$target" "${limit[@]}" -max_len=1024 -timeout=20 -artifact_prefix="$found/" -print_final_stats=1 \
    "$found" "$kept" >"$log" 2>&1; then
    tail -n 60 "$log" >&2
    echo "$target: a finding. Again: build/fuzz/bin/$target $(ls -t "$found"/{crash,timeout,oom,leak}-* 2>/dev/null | head -n 1)"
    exit 1
  fi
  sed -nE "s/stat::number_of_executed_units: *(.*)/$target: \1 inputs, nothing found/p" "$log"
  if [[ -n $keep ]]; then
    rm -rf "$kept.new" && mkdir "$kept.new"
    build/fuzz/bin/"$target" -merge=1 -max_len=1024 "$kept.new" "$found" "$kept" >"$log" 2>&1
    rm -rf "$kept" && mv "$kept.new" "$kept"
    echo "$target: $(ls "$kept" | wc -l) inputs kept"
  fi
done
