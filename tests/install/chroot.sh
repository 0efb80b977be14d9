#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Tries a package where there are no sources: a fresh Debian 12 by debootstrap, the package by apt, then what a user does.
#   cmake --build build/release --target package && sudo tests/install/chroot.sh build/release/lamina_*.deb [FOLDER]
# FOLDER keeps the Debian for another time. It says where it stops; nothing is left mounted.
set -euo pipefail
package=$(realpath "$1")
root=${2:-$(mktemp -d)}
source=$(cd "$(dirname "$0")/../.." && pwd)
[ "$(id -u)" -eq 0 ] || { echo "chroot.sh: needs root, for debootstrap and chroot" >&2; exit 2; }
command -v debootstrap >/dev/null || { echo "chroot.sh: install Debian's package debootstrap" >&2; exit 2; }
cleanup() {
  umount "$root/proc" 2>/dev/null || true
  [ -n "${2:-}" ] || rm -rf "$root"
}
trap 'cleanup "$@"' EXIT
[ -d "$root/usr" ] || debootstrap --variant=minbase --include=ca-certificates bookworm "$root"
mountpoint -q "$root/proc" || mount -t proc proc "$root/proc"
cp /etc/resolv.conf "$root/etc/"
cp "$package" "$root/root/lamina.deb"

rm -rf "$root/root/mine" && cp -r "$source/examples/variant" "$root/root/mine"

chroot "$root" env -i PATH=/usr/bin:/bin:/usr/sbin:/sbin HOME=/root LANG=C.UTF-8 DEBIAN_FRONTEND=noninteractive bash -euxc '
  cd /root
  apt-get update -qq
  apt-get install -y -qq --no-install-recommends --reinstall ./lamina.deb >apt.log 2>&1 || { cat apt.log; exit 1; }
  lamina --version
  lamina list | tail -3
  # On a busy machine a timer may not be certified, which is status 1 with every cell there.
  lamina compare heart --quick --size 256x256 || [ $? -eq 1 ]
  lamina compare heart --quick --size 128x128 --variants-dir mine --variant one_tap --out own || [ $? -eq 1 ]
  grep -q one_tap own/index.html
  if grep "\"status\":\"failed\"" lamina-out/record.jsonl own/record.jsonl; then exit 1; fi
  cp -r /usr/share/lamina before
  lamina gate heart --against before --size 128x128 --out gate-same
  sed -i "s/ambient.rgb/(0.5 * ambient.rgb)/" before/shaders/common/*.glsl before/shaders/layered_material/*   # another picture
  status=0; lamina gate heart --against before --size 128x128 --no-time --out gate-other || status=$?
  [ "$status" -eq 1 ]
  status=0; lamina compare hart || status=$?
  [ "$status" -eq 2 ]
  ls /usr/share/man/man1/lamina*.1.gz | wc -l
  du -sh --apparent-size /usr/share/lamina /usr/bin/lamina
'
