#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# scripts/tidy.sh core|all [BUILD]: clang-tidy 19 over the core rooms, or over all files. Exit code 77: no clang-tidy.
set -euo pipefail
source=$(cd "$(dirname "$0")/.." && pwd)
build=${2:-$source/build}
command -v clang-tidy-19 >/dev/null || { echo "tidy: clang-tidy-19 is missing" >&2; exit 77; }
[[ -f $build/compile_commands.json ]] || cmake -S "$source" -B "$build" >/dev/null

cd "$source"
case ${1:-} in
  core) folders=(src/odas/{base,array,dsp,localization,tracking,separation,classification,pipeline}) ;;
  all) folders=(src/odas app tests) ;;
  *) echo "usage: scripts/tidy.sh core|all [BUILD]" >&2; exit 2 ;;
esac
tests=()
if [[ $1 == core ]]; then tests=(! -name '*_test.cpp'); fi
# What g++ alone knows means nothing to clang.
find "${folders[@]}" -name '*.cpp' ! -name '*_bench.cpp' "${tests[@]}" -print0 |
  xargs -0 -n 1 -P "$(nproc)" clang-tidy-19 -p "$build" --quiet --extra-arg=-Wno-unknown-warning-option \
    --extra-arg=-Wno-ignored-gch 2> \
    >(grep -vE '^[0-9]+ warnings? (generated|treated)' >&2)
