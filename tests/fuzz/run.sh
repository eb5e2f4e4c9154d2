#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Feeds every parser with bytes that a fuzzer makes up, under the address and undefined-behaviour sanitizers: reports and
# features, captures and their notes, recordings, tables, profiles, scripts, addresses, settings, descriptors, libraries.
# Builds what it needs with clang. Usage: tests/fuzz/run.sh [--seconds 20 | --runs N] [--jobs 2] [--only NAME] [--keep]
#   --seconds, --runs  for each target     --jobs  targets at a time     --only  this target, such as csv
#   --keep             what reached new code is kept in tests/fuzz/corpus, the least set of inputs that reaches as much
# Exit: 0 nothing found; 1 a finding (its input is named), or there is no clang with libFuzzer here.
set -euo pipefail
cd "$(dirname "$0")/../.."
seconds=20 runs= jobs=2 only='*' keep=
while [[ $# -gt 0 ]]; do
  case $1 in
    --seconds) seconds=${2:?seconds}; shift 2 ;;
    --runs) runs=${2:?runs}; shift 2 ;;
    --jobs) jobs=${2:?jobs}; shift 2 ;;
    --only) only=${2:?name}; shift 2 ;;
    --keep) keep=1; shift ;;
    *) sed -n '3,8p' "$0" >&2; exit 2 ;;
  esac
done
command -v clang++ >/dev/null && compgen -G "$(clang++ -print-resource-dir)/lib/linux/libclang_rt.fuzzer-*" >/dev/null ||
  { echo "no clang with libFuzzer here (Debian: clang, libclang-rt-14-dev): not fuzzed" >&2; exit 1; }

targets=()
for source in tests/fuzz/$only\_fuzz.cpp; do targets+=("$(basename "$source" .cpp)"); done
mkdir -p build
packaging/build.sh fuzz "${targets[@]}" >build/fuzz.log 2>&1 || { tail -n 40 build/fuzz.log >&2; exit 1; }

# A leak is looked for once at the end, not after each of a hundred thousand inputs.
export ASAN_OPTIONS=quarantine_size_mb=32:detect_leaks=1 QT_QPA_PLATFORM=offscreen
run_one() { # TARGET
  local target=$1 kept=tests/fuzz/corpus/${1%_fuzz} found=build/fuzz/found/$1 log=build/fuzz/$1.log
  local limit=("-max_total_time=$seconds") longest=4096
  [[ -z $runs ]] || limit=("-runs=$runs")
  [[ $target != protocol_fuzz ]] || longest=1024
  mkdir -p "$kept" "$found"
  # New inputs go to the first folder; the kept ones are only read.
  if ! build/fuzz/bin/"$target" "${limit[@]}" -max_len=$longest -timeout=20 -rss_limit_mb=1000 -malloc_limit_mb=500 \
    -artifact_prefix="$found/" -print_final_stats=1 "$found" "$kept" >"$log" 2>&1; then
    tail -n 60 "$log" >&2
    local input; input=$(ls -t "$found"/{crash,timeout,oom,leak}-* 2>/dev/null | head -n 1)
    echo "$target: a finding. Again: build/fuzz/bin/$target $input"
    # Where the folder is gone, such as on a build machine, the log still has it.
    [[ -z $input ]] || { echo "The input, to be decoded by: base64 -d | gunzip"; gzip -9c "$input" | base64; }
    return 1
  fi
  sed -nE "s/stat::number_of_executed_units: *(.*)/$target: \1 inputs, nothing found/p" "$log"
  if [[ -n $keep ]]; then
    rm -rf "$kept.new" && mkdir "$kept.new"
    build/fuzz/bin/"$target" -merge=1 -max_len=$longest "$kept.new" "$found" "$kept" >"$log" 2>&1
    rm -rf "$kept" && mv "$kept.new" "$kept"
    echo "$target: $(ls "$kept" | wc -l) inputs kept"
  fi
}

failed=0 running=0
for target in "${targets[@]}"; do
  if ((running >= jobs)); then
    wait -n || failed=1
    running=$((running - 1))
  fi
  run_one "$target" &
  running=$((running + 1))
done
while ((running > 0)); do
  wait -n || failed=1
  running=$((running - 1))
done
exit $failed
