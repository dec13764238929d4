#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# scripts/install_packages.sh [--check] GROUP...: installs the Debian packages that are missing, and says which.
# Groups: build (programs and libraries), test (all that `make test` needs), bench, arm64 (cross build of the core
# and its tests), arm64-programs (of all, for make deb), web (the checks of the Studio's page).
# With --check nothing is installed: what is missing is said, exit code 1. When all is there, no network is touched.
set -euo pipefail

build=(g++ cmake make pkg-config libfftw3-dev libsamplerate0-dev libhwy-dev libconfig++-dev
       libsndfile1-dev libasound2-dev libpulse-dev libfmt-dev libcli11-dev nlohmann-json3-dev libcairo2-dev
       libboost1.74-dev libssl-dev libcurl4-openssl-dev libqrencode-dev)
test=(ninja-build libgtest-dev librapidcheck-dev libbenchmark-dev
      clang-14 libclang-rt-14-dev clang-format-14 clang-tidy-19
      libasound2-plugins pulseaudio pulseaudio-utils netcat-openbsd)
bench=(libbenchmark-dev valgrind)
arm64=(g++-aarch64-linux-gnu qemu-user-static libc6:arm64 libstdc++6:arm64 libfftw3-dev:arm64
       libsamplerate0-dev:arm64 libhwy-dev:arm64 libgtest-dev:arm64 librapidcheck-dev:arm64)

arm64_programs=(libconfig++-dev:arm64 libsndfile1-dev:arm64 libasound2-dev:arm64 libpulse-dev:arm64
                libfmt-dev:arm64 libcairo2-dev:arm64 libssl-dev:arm64 libcurl4-openssl-dev:arm64
                libqrencode-dev:arm64 dpkg-dev)

# Node may be there from elsewhere, with an npm of its own, which Debian's package of that name conflicts with.
web=(chromium)
command -v node >/dev/null || web+=(nodejs)
command -v npm >/dev/null || web+=(npm)

say() { echo "packages: $*" >&2; }

check_only=false
wanted=() groups=()
for group in "$@"; do
  case $group in
    --check) check_only=true ;;
    build) wanted+=("${build[@]}") ;;
    test) wanted+=("${test[@]}") ;;
    bench) wanted+=("${bench[@]}") ;;
    arm64) wanted+=("${arm64[@]}") ;;
    web) wanted+=("${web[@]}") ;;
    arm64-programs) wanted+=("${arm64_programs[@]}") ;;
    *) say "no group '$group': build, test, bench, arm64, arm64-programs or web"; exit 2 ;;
  esac
  [[ $group == --check ]] || groups+=("$group")
done

if ! command -v dpkg-query >/dev/null; then
  say "this is no Debian; see to it yourself that there is: ${wanted[*]}"
  exit 0
fi

missing=()
for package in "${wanted[@]}"; do
  status=$(dpkg-query -W -f '${db:Status-Status}\n' "$package" 2>/dev/null || true)
  [[ $status == installed* ]] || missing+=("$package")
done
if ((${#missing[@]} == 0)); then exit 0; fi

if $check_only; then
  say "missing: ${missing[*]}"
  say "install them with: $0 ${groups[*]}"
  exit 1
fi

as_root=()
if ((EUID != 0)); then
  command -v sudo >/dev/null || { say "missing: ${missing[*]}; install them as root, there is no sudo"; exit 1; }
  as_root=(sudo)
fi

say "installing ${missing[*]}"
export DEBIAN_FRONTEND=noninteractive
if [[ ${missing[*]} == *:arm64* ]] && ! dpkg --print-foreign-architectures | grep -qx arm64; then
  say "adding the architecture arm64 to dpkg"
  "${as_root[@]}" dpkg --add-architecture arm64
fi
"${as_root[@]}" apt-get update -qq </dev/null

# Packages of two architectures can push each other out: then rather none of them.
removed=$(apt-get -s install --no-install-recommends "${missing[@]}" </dev/null | awk '/^Remv/ {print $2}')
if [[ -n $removed ]]; then
  say "not installed, since apt would remove: $removed"
  exit 1
fi
"${as_root[@]}" apt-get install -y -qq --no-install-recommends "${missing[@]}" </dev/null >&2
