#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Installs the package in a bare Debian 12 and uses it as a newcomer does: demonstration, tour, manual pages, an upgrade under
# a library in use, removal, purge. As root; by hand, and in CI where time allows.
# Usage: packaging/test_deb.sh [build/deb/gripscope_VERSION_amd64.deb]   (builds the package where none is named)
# The bare system is kept for the next call in DEB_TEST_DIR (a folder in TMPDIR without it).
set -euo pipefail
cd "$(dirname "$0")/.."
package=${1:-}
[[ $EUID -eq 0 ]] || { echo "This needs root: it makes a system of its own and enters it." >&2; exit 2; }
[[ -n $package ]] || { packaging/deb.sh build/deb; package=$(ls -t build/deb/gripscope_*.deb | head -n 1); }
dir=${DEB_TEST_DIR:-${TMPDIR:-/tmp}/gripscope-deb-test}
mkdir -p "$dir"
command -v debootstrap >/dev/null || apt-get install -y debootstrap
base=$dir/base.tar
if [[ ! -s $base ]]; then
  debootstrap --variant=minbase --include=ca-certificates bookworm "$dir/base" >"$dir/debootstrap.log" 2>&1
  tar -C "$dir/base" -cf "$base.part" . && mv "$base.part" "$base"
  rm -rf "$dir/base"
fi

machine=$(mktemp -d "$dir/machine.XXXX")
leave() {
  local mounted
  for mounted in sys dev/pts dev proc; do ! mountpoint -q "$machine/$mounted" || umount "$machine/$mounted"; done
  rm -rf --one-file-system "$machine"
}
trap leave EXIT
tar -C "$machine" -xf "$base"
# Package sources and name resolution as this computer has them.
rm -f "$machine/etc/apt/sources.list"
cp /etc/apt/sources.list "$machine/etc/apt/" 2>/dev/null || true
cp -r /etc/apt/sources.list.d/. "$machine/etc/apt/sources.list.d/" 2>/dev/null || true
cp /etc/apt/apt.conf.d/* "$machine/etc/apt/apt.conf.d/" 2>/dev/null || true
cp /etc/resolv.conf "$machine/etc/resolv.conf"
for mounted in proc sys dev dev/pts; do mount --bind "/$mounted" "$machine/$mounted"; done

# The same package as an earlier version, to upgrade from.
mkdir "$machine/packages"
cp "$package" "$machine/packages/new.deb"
dpkg-deb -R "$package" "$machine/packages/tree"
sed -i -E 's/^Version: .*/Version: 0.0.9/' "$machine/packages/tree/DEBIAN/control"
dpkg-deb --root-owner-group -Znone -b "$machine/packages/tree" "$machine/packages/old.deb" >/dev/null
rm -rf "$machine/packages/tree"

cp packaging/test_deb_inside.sh "$machine/packages/"
env -i HOME=/root PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin LANG=C.UTF-8 DEBIAN_FRONTEND=noninteractive \
  chroot "$machine" /bin/bash /packages/test_deb_inside.sh
echo "$(basename "$package"): all passed in a bare Debian 12"
