#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# The device side on real hidraw nodes: boots Debian's kernel in QEMU (no KVM, no root) with the virtual gripper behind
# /dev/uhid, and prints a table. Packages come by apt-get download and are only unpacked.
# Usage: tests/end_to_end/hid_vm.sh [BUILD_FOLDER] [REPLUGS] [RACES] [MOMENTS]    (default: build/release 100 300 50)
# MOMENTS: unplugs at random moments; 1000 by hand, before a release. Exit 77: the packages cannot be had.
set -euo pipefail
cd "$(dirname "$0")/../.."
build=${1:-build/release} replugs=${2:-100} races=${3:-300} moments=${4:-50}
work=$build/hid_vm
cmake --build "$build" --target hid_vm_check gripscope-virtual-gripper
mkdir -p "$work/debs" "$work/system"

# 1. The machine: QEMU where it is not installed, a shell, the kernel.
if [[ ! -e $work/unpacked ]]; then
  download() {
    names=(busybox-static cpio)
    command -v qemu-system-x86_64 >/dev/null || mapfile -t -O 2 names < <(
      apt-get install --simulate --no-install-recommends qemu-system-x86 | awk '/^Inst/ {print $2}')
    names+=("$(apt-cache depends linux-image-cloud-amd64 | awk '/Depends: linux-image/ {print $2; exit}')")
    (cd "$work/debs" && apt-get download "${names[@]}" 2>/dev/null)
  }
  # The package lists may be old or absent: fetch them, where one may, when the first try fails.
  download || { [[ $EUID -eq 0 ]] && apt-get update -qq && download; } ||
    { echo "hid_vm: not run, these packages cannot be had: ${names[*]}"; exit 77; }
  for package in "$work"/debs/*.deb; do dpkg-deb -x "$package" "$work/system"; done
  touch "$work/unpacked"
fi
system=$(realpath "$work/system")
qemu=$(command -v qemu-system-x86_64 || echo "$system/usr/bin/qemu-system-x86_64")

# 2. The first file system: the programs, the libraries they name, three modules.
root=$work/root
rm -rf "$root"
mkdir -p "$root"/{bin,dev,proc,sys,tmp,modules}
cp "$system/bin/busybox" "$root/bin/"
find "$system/lib/modules" \( -name hid.ko -o -name hid-generic.ko -o -name uhid.ko \) -exec cp {} "$root/modules/" \;
for program in hid_vm_check gripscope-virtual-gripper; do
  cp "$build/bin/$program" "$root/bin/"
  ldd "$build/bin/$program" | grep -oE '/[^ ]+\.so[^ ]*' | while read -r library; do
    mkdir -p "$root$(dirname "$library")"
    cp -L "$library" "$root$library"
  done
done
cat > "$root/init" <<'INIT'
#!/bin/busybox sh
/bin/busybox mount -t proc proc /proc
/bin/busybox mount -t sysfs sys /sys
/bin/busybox mount -t devtmpfs dev /dev
/bin/busybox mount -t tmpfs tmp /tmp
/bin/busybox insmod /modules/hid.ko
/bin/busybox insmod /modules/hid-generic.ko
/bin/busybox insmod /modules/uhid.ko
export HOME=/tmp LC_ALL=C.UTF-8
arguments=$(/bin/busybox sed -n 's/.*check=\([^ ]*\).*/\1/p' /proc/cmdline | /bin/busybox tr , ' ')
/bin/hid_vm_check $arguments
echo "hid_vm exit $?"
/bin/busybox poweroff -f
INIT
chmod +x "$root/init"
(cd "$root" && find . | "$system/bin/cpio" --quiet -o -H newc) | gzip -1 > "$work/root.cpio.gz"

# 3. Each run is a machine of its own.
boot() { # NAME CHECK ARGUMENTS OF QEMU...
  local log=$work/$1.log check=$2
  shift 2
  LD_LIBRARY_PATH=$system/usr/lib/x86_64-linux-gnu:$system/lib/x86_64-linux-gnu timeout 600 "$qemu" \
    -L "$system/usr/share/qemu" -L "$system/usr/share/seabios" -m 768 "$@" -nographic -no-reboot -nodefaults \
    -serial stdio -kernel "$(echo "$system"/boot/vmlinuz-*)" -initrd "$work/root.cpio.gz" \
    -append "console=ttyS0 quiet panic=-1 check=$check" > "$log" 2>&1 < /dev/null || true
  grep -E '^(ok|FAIL) ' "$log" | tr -d '\r' || true
  if ! grep -q '^hid_vm exit 0' "$log"; then
    echo "the virtual machine's last words ($log):"
    tail -15 "$log"
    return 1
  fi
}
SECONDS=0
boot one check,"$replugs" -accel tcg,thread=single -icount shift=2,sleep=off -smp 1
boot moments moments,"$moments" -accel tcg,thread=single -icount shift=2,sleep=off -smp 1
boot two race,"$races" -accel tcg,thread=multi -smp 2
echo "hid_vm: all passed in $SECONDS s"
