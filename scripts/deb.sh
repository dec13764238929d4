#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# scripts/deb.sh [amd64|arm64]...: makes the Debian packages odas and libodas-dev, in build/packages; without an
# argument for both. That of the other architecture is cross-built, and looked at under qemu.
set -euo pipefail
cd "$(dirname "$0")/.."
mkdir -p build/packages

# pack BUILD: the packages of a build that is done.
pack() {
  (cd "$1" && rm -rf packages && cpack -G DEB >/dev/null)
  [[ $1 -ef build ]] || cp "$1"/packages/*.deb build/packages
}

native() {
  scripts/install_packages.sh build
  cmake --preset release >/dev/null
  cmake --build build --target programs
  pack build
}

cross() {
  scripts/install_packages.sh build arm64 arm64-programs
  cmake --preset arm64-programs >/dev/null
  cmake --build build-arm64-programs --target programs
  pack build-arm64-programs
  local folder
  folder=$(mktemp -d)
  dpkg-deb -x build/packages/odas_*_arm64.deb "$folder"
  qemu-aarch64-static -cpu cortex-a72 "$folder/usr/bin/odas" check configs/sample.cfg >/dev/null
  rm -rf "$folder"
}

host=$(dpkg --print-architecture)
for architecture in "${@:-$host arm64}"; do
  for one in $architecture; do
    case $one in
      "$host") native ;;
      arm64) cross ;;
      *) echo "deb: no way to make a package for $one here: $host or arm64" >&2; exit 2 ;;
    esac
  done
done
ls -l build/packages/*.deb
