#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Builds the Debian package. Usage: packaging/deb.sh [FOLDER]   (default: build/deb)
# Writes gripscope_VERSION_ARCHITECTURE.deb and what Debian keeps beside it, and the list of all parts with their licences
# (SPDX). lintian has nothing to say of it. Two builds of the same tree are the same to the byte.
set -euo pipefail
cd "$(dirname "$0")/.."
packaging/install_dependencies.sh build run package
out=${1:-build/deb}
mkdir -p "$out"
out=$(cd "$out" && pwd)

version=$(sed -nE 's/^project\(Gripscope VERSION ([0-9.]+).*/\1/p' CMakeLists.txt)
[[ $version == "$(dpkg-parsechangelog -l packaging/debian/changelog -S Version)" ]] || {
  echo "packaging/debian/changelog does not begin with version $version of CMakeLists.txt" >&2
  exit 1
}
# One date for all that is written: the changelog's.
SOURCE_DATE_EPOCH=$(dpkg-parsechangelog -l packaging/debian/changelog -S Timestamp)
export SOURCE_DATE_EPOCH
# debhelper gives the build a home folder of its own; a compiler cache stays where it is.
export CCACHE_DIR=${CCACHE_DIR:-${XDG_CACHE_HOME:-$HOME/.cache}/ccache}

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
tree=$work/gripscope-$version
packaging/licences.sh "$work/licensed"
# The top of the repository is no place for debian/, hence a copy.
mkdir "$tree"
git ls-files -z --cached --others --exclude-standard | xargs -0 cp --parents -t "$tree"
cp -r packaging/debian "$tree/debian"
cp "$work/licensed/gripscope.spdx" "$tree/debian/gripscope.spdx"
find "$tree" -exec touch -h -d "@$SOURCE_DATE_EPOCH" {} +

(cd "$tree" && dpkg-buildpackage --build=binary --no-sign) >"$out/build.log" 2>&1 || {
  tail -n 60 "$out/build.log" >&2
  exit 1
}
cp "$work"/gripscope_"$version"_* "$out"
# Nothing to say, or a reason in packaging/debian/gripscope.lintian-overrides.
lintian -EviI --pedantic --fail-on error,warning,info,pedantic "$out"/gripscope_"$version"_*.changes >"$out/lintian.log" 2>&1 || {
  cat "$out/lintian.log" >&2
  exit 1
}
cp "$work/licensed/gripscope.spdx" "$out/gripscope_$version.spdx"
echo "$out:"
(cd "$out" && sha256sum ./gripscope_"$version"_*.deb "gripscope_$version.spdx")
