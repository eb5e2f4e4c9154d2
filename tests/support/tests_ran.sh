#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Did every test run? Says which test class is not registered with ctest, which registered test the log of a run does
# not show as passed, and which was skipped without being allowed to (may_be_skipped.txt). Exit 1 when there is any.
# Usage: tests/support/tests_ran.sh BUILD_FOLDER [LOG [FILTERS OF CTEST...]]    (those that the run had; without a log
# only what is registered is looked at)
set -euo pipefail
build=${1:?a build folder} log=${2:-}
shift $(($# < 2 ? $# : 2))
root=$(cd "$(dirname "$0")/../.." && pwd)
allowed=$root/tests/support/may_be_skipped.txt
wrong=0
tell() { echo "tests_ran: $1" >&2; wrong=1; }

# 1. What the sources define, by the names that tests/CMakeLists.txt gives, but for the folders it says it leaves out.
left_out=$(cut -d' ' -f1 "$build/tests/left_out.txt")
registered=$(ctest --test-dir "$build" -N | sed -nE 's/^ *Test +#[0-9]+: //p')
while read -r file; do
  folder=$(dirname "${file#"$root"/tests/}")
  grep -qxF "$folder" <<<"$left_out" && continue
  class=$(basename "$file" .cpp | sed -E 's/(^|_)(.)/\U\2/g')
  name=${folder//\//.}.$class
  grep -qxF "$name" <<<"$registered" || tell "$name is not registered with ctest ($file)"
  grep -q "^GRIPSCOPE_TEST($class)" "$file" || tell "$file does not register $class with GRIPSCOPE_TEST"
done < <(find "$root/tests" -name '*_test.cpp' | sort)
[[ -n $log ]] || exit "$wrong"

# 2. What ctest was to run, and what it says became of it.
may_be_skipped() { # NAME
  local name where why
  while read -r name where why; do
    [[ $name == "$1" ]] || continue
    case $where in
      with:*) (cd "$root" && [[ -e ${where#with:} ]]) && { echo "skipped: $1 ($why)"; return 0; } ;;
      without:*) (cd "$root" && [[ ! -e ${where#without:} ]]) && { echo "skipped: $1 ($why)"; return 0; } ;;
    esac
  done < <(grep -v '^#' "$allowed")
  return 1
}
count=0
while read -r name; do
  count=$((count + 1))
  outcome=$(sed -nE "s/^ *[0-9]+\/[0-9]+ Test +#[0-9]+: ${name//./\\.} \.+ *(\*\*\*)?(Passed|Failed|Skipped|Not Run|Timeout|Exception).*/\2/p" "$log" | tail -n 1)
  case $outcome in
    Passed) ;;
    Skipped) may_be_skipped "$name" || tell "$name was skipped; tests/support/may_be_skipped.txt does not allow it here" ;;
    "") tell "$name did not run" ;;
    *) tell "$name: $outcome" ;;
  esac
done < <(ctest --test-dir "$build" -N "$@" | sed -nE 's/^ *Test +#[0-9]+: //p')
[[ $count -gt 0 ]] || tell "no test was to run"
[[ $wrong == 0 ]] && echo "tests_ran: $count tests, each accounted for"
exit "$wrong"
