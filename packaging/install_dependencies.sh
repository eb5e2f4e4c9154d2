#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Installs the packages of dependencies.txt that are missing here and says which.
# Usage: packaging/install_dependencies.sh KIND...      (kinds: build run test check package)
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
[[ $# -gt 0 ]] || { echo "usage: $0 build|run|test|check|package ..." >&2; exit 2; }

command -v dpkg-query >/dev/null || {
  echo "This set-up knows Debian and Ubuntu. Elsewhere, install the counterparts of $here/dependencies.txt by hand." >&2
  exit 1
}
mapfile -t wanted < <(awk -v kinds=" $* " '!/^#/ && NF == 2 && index(kinds, " " $2 " ") { print $1 }' "$here/dependencies.txt")
mapfile -t missing < <(for package in "${wanted[@]}"; do
  [[ $(dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null) == installed ]] || echo "$package"
done)
if [[ ${#missing[@]} -eq 0 ]]; then
  echo "All ${#wanted[@]} packages are installed."
  exit 0
fi

echo "Installing ${#missing[@]} of ${#wanted[@]} packages: ${missing[*]}"
as_root=()
if [[ $EUID -ne 0 ]]; then
  command -v sudo >/dev/null || { echo "Run this as root, or install sudo: packages are missing." >&2; exit 1; }
  as_root=(sudo)
fi
log=$(mktemp)
trap 'rm -f "$log"' EXIT
install() { "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends "${missing[@]}" >"$log" 2>&1; }
# The package lists may be old or absent: fetch them only when the first try fails.
install || { "${as_root[@]}" apt-get update -qq && install; } || {
  tail -n 20 "$log" >&2
  echo "The packages could not be installed; the lines above say why." >&2
  exit 1
}
