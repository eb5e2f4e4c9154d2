#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# What packaging/test_deb.sh does inside the bare system: /packages/old.deb and new.deb are there. A line a step, with its time.
set -euo pipefail
cd /packages
step() {
  local name=$1 start=$SECONDS
  shift
  "$@" >/packages/log 2>&1 || { tail -n 40 /packages/log; echo "failed: $name"; exit 1; }
  printf '%-58s %4d s\n' "$name" $((SECONDS - start))
}
person() { runuser -u anna -- env HOME=/home/anna XDG_RUNTIME_DIR=/tmp/anna-run "$@"; }
# Every file that is there but for what apt and the test keep, to see what is left behind.
files() { find / -xdev \( -path /proc -o -path /sys -o -path /dev -o -path /packages -o -path /tmp -o -path /var/cache -o -path /var/log -o -path /var/lib/apt \) -prune -o -print | sort; }
version_is() { [[ $(dpkg-query -W -f '${Version}' gripscope) == "$1" ]]; }

adduser_() { useradd -m anna && install -d -o anna -m 700 /tmp/anna-run; }
step "a person" adduser_
step "package lists" apt-get update
# Man pages are kept, which minimal images leave out.
rm -f /etc/dpkg/dpkg.cfg.d/docker
step "a display and man, for the test" apt-get install -y --no-install-recommends xvfb xauth man-db sqlite3
# Also those that it recommends: apt installs them too, and keeps them.
step "packages that it needs, without itself" \
  bash -c 'apt-get install -y --no-install-recommends $( (dpkg-deb -f new.deb Depends; dpkg-deb -f new.deb Recommends) | tr "," "\n" | sed -E "s/[(|].*//; s/ //g" | sort -u)'
files >before
step "apt install ./gripscope_0.0.9 (the version before)" apt-get install -y ./old.deb
version_is 0.0.9

step "gripscope-cli demo" person gripscope-cli demo
step "four example types" person gripscope-cli library examples
# A squeeze, and the verdict on it: what the package promises for the first minute.
verdict() {
  cd /home/anna
  person gripscope-cli record --device 'virtual:?object=B&seed=99&speed=0' --arm -o /home/anna/part.csv
  person gripscope-cli classify /home/anna/part.csv | tee verdict
  grep -qw B verdict
}
step "a squeeze and its verdict" verdict

# An upgrade while a program has the library open and writes to it.
in_use() {
  local keep=/home/anna/in_use.log
  person bash -c 'cd /home/anna; for ((i = 1000; i < 9000; ++i)); do
    [[ ! -e /tmp/enough ]] || exit 0
    gripscope-cli record --device "virtual:?object=B&seed=$i&speed=0" --arm -o one.csv && gripscope-cli enroll --type "In use" one.csv || exit 1
  done' >"$keep" 2>&1 &
  local writer=$!
  sleep 1
  apt-get install -y ./new.deb
  touch /tmp/enough
  wait $writer
}
cd /home/anna
new_version=$(dpkg-deb -f /packages/new.deb Version)
cp /packages/new.deb /packages/old.deb /home/anna/
step "upgrade over a library in use" in_use
version_is "$new_version"
step "the library is whole" person gripscope-cli library verify
self_check() { person gripscope-cli self-check --json >/home/anna/check.json; }
step "gripscope-cli self-check" self_check

tour() {
  person timeout 900 xvfb-run -a -s "-screen 0 1600x1000x24" gripscope --tour /home/anna/tour --size 1280x800
  [[ $(find /home/anna/tour -name '*.png' -size +10k | wc -l) -ge 6 ]]
}
step "gripscope --tour under Xvfb" tour
pages() {
  local page
  for page in gripscope gripscope-cli gripscope-virtual-gripper; do
    MANWIDTH=100 man -E UTF-8 $page | grep -q -- "$page"
  done
  man -E UTF-8 gripscope-cli | grep -q -- --study-variation
}
step "manual pages" pages
installed() {
  local file
  for file in /usr/share/applications/org.gripscope.gripscope.desktop /usr/share/metainfo/org.gripscope.gripscope.metainfo.xml \
    /usr/share/mime/packages/org.gripscope.gripscope.xml /usr/share/icons/hicolor/scalable/apps/org.gripscope.gripscope.svg \
    /usr/lib/udev/rules.d/70-gripscope.rules /usr/share/doc/gripscope/manual/index.md /usr/share/doc/gripscope/gripscope.spdx.gz \
    /usr/share/doc/gripscope/copyright; do
    test -s $file || { echo "$file is missing"; return 1; }
  done
}
step "what a desktop and udev look for" installed

rm -rf /home/anna/tour
sum() { (cd /home/anna/.local/share/gripscope && find . -type f | sort | xargs sha256sum); }
sum >/packages/data_before
step "remove" apt-get remove -y gripscope
step "purge" apt-get purge -y gripscope
sum >/packages/data_after
files >/packages/after
cmp /packages/data_before /packages/data_after
left=$(comm -13 /packages/before /packages/after | grep -v '^/home/anna' || true)
[[ -z $left ]] || { echo "left behind:"; echo "$left"; exit 1; }
echo "nothing is left behind but $(wc -l </packages/data_after) files of the person's own, as they were"
