#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# scripts/test_deb.sh BUILD: packs a build, installs the package into a root of its own (this machine stays as it
# is), runs what is in it, and removes it. Exit code 77: not possible here.
set -euo pipefail
source=$(cd "$(dirname "$0")/.." && pwd)
build=$(cd "$1" && pwd)
command -v dpkg-deb dpkg-shlibdeps >/dev/null || { echo "deb: no dpkg here"; exit 77; }
((EUID == 0)) || command -v fakeroot >/dev/null || { echo "deb: needs root, or fakeroot"; exit 77; }
as_root=(fakeroot)
if ((EUID == 0)); then as_root=(); fi
fail() { echo "deb: $*" >&2; exit 1; }

(cd "$build" && rm -rf packages && cpack -G DEB >/dev/null) || fail "cpack failed"
package=$(ls "$build"/packages/odas_*.deb)
root=$build/deb-test
rm -rf "$root"
mkdir -p "$root/var/lib/dpkg/info" "$root/var/lib/dpkg/updates" "$root/var/log"
: >"$root/var/lib/dpkg/status"

# Its scripts run outside of a chroot: by DPKG_ROOT they know that this machine is none of their business.
dpkg_in_root() {
  "${as_root[@]}" dpkg --root="$root" --force-depends --force-script-chrootless --force-bad-path --log=/dev/null "$@" \
    >"$build/deb-test.log" 2>&1 || { cat "$build/deb-test.log" >&2; fail "dpkg $1 failed"; }
}

dpkg_in_root --install "$package"
for file in usr/bin/odas usr/bin/odaslive usr/bin/odasserver etc/odas/README usr/lib/systemd/system/odas@.service \
            usr/share/odas/configs/respeaker_usb_4_mic.cfg usr/share/man/man1/odas.1 usr/share/doc/odas/copyright; do
  [[ -s $root/$file ]] || fail "$file is not in the package"
done
"$root/usr/bin/odas" --version | grep -q "^odas $(dpkg-deb -f "$package" Version)\$" || fail "another version inside"
"$root/usr/bin/odas" run "$source/samples/sample_4mic.flac" -c "$root/usr/share/odas/configs/sample.cfg" \
  -o "$root/tmp/heard" | grep -q '^source' || fail "the installed program hears nothing"
"$root/usr/bin/odaslive" -h >/dev/null
[[ $(dpkg-deb -f "$package" Depends) == *libsndfile1* ]] || fail "the package does not say what it needs"
if command -v systemd-analyze >/dev/null; then
  # The unit as installed, but for the path of the program, which is not on this machine.
  unit=$root/tmp/odas@test.service
  sed "s|/usr/bin/odas|$root/usr/bin/odas|" "$root/usr/lib/systemd/system/odas@.service" >"$unit"
  systemd-analyze verify --man=no "$unit" 2>"$build/deb-test.log" || { cat "$build/deb-test.log" >&2; fail "the unit is wrong"; }
fi

echo "# mine" >>"$root/etc/odas/mine.cfg"
mkdir -p "$root/var/lib/odas" && touch "$root/var/lib/odas/recorded.wav"
dpkg_in_root --remove odas
[[ ! -e $root/usr/bin/odas && ! -e $root/usr/share/odas ]] || fail "removing leaves programs behind"
[[ -s $root/etc/odas/mine.cfg && -e $root/var/lib/odas/recorded.wav ]] || fail "removing takes the user's files along"
dpkg_in_root --purge odas
[[ ! -e $root/etc/odas/README && ! -e $root/var/lib/odas && -s $root/etc/odas/mine.cfg ]] || fail "purging takes the wrong files"
rm -rf "$root" "$build/deb-test.log"
echo "$(basename "$package") installs, runs and goes"
