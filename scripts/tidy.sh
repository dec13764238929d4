#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# scripts/tidy.sh core|all [BUILD]: clang-tidy 19 over the core rooms, or over all files, as BUILD compiles them: where
# that is many files together, each header is read once. Exit code 77: no clang-tidy.
set -euo pipefail
source=$(cd "$(dirname "$0")/.." && pwd)
build=${2:-$source/build}
command -v clang-tidy-19 >/dev/null || { echo "tidy: clang-tidy-19 is missing" >&2; exit 77; }
[[ -f $build/compile_commands.json ]] || cmake -S "$source" --preset release -B "$build" >/dev/null

core='base|array|dsp|localization|tracking|separation|classification|pipeline'
case ${1:-} in
  core) wanted="/odas_($core)\.dir/Unity/|$source/src/odas/($core)/"; unwanted='_test\.cpp$' ;;
  all) wanted="\.dir/Unity/|$source/(src/odas|app|tests)/"; unwanted='/cmake_pch' ;;
  *) echo "usage: scripts/tidy.sh core|all [BUILD]" >&2; exit 2 ;;
esac
# What g++ alone knows means nothing to clang; files that are compiled together are included by one that nobody wrote.
sed -nE 's/^ *"file": "(.*)",?$/\1/p' "$build/compile_commands.json" | sort -u |
  { grep -E "$wanted" || true; } | { grep -vE "$unwanted" || true; } |
  xargs -d '\n' -n 1 -P "$(nproc)" clang-tidy-19 -p "$build" --config-file="$source/.clang-tidy" --quiet \
    --checks=-bugprone-suspicious-include --extra-arg=-Wno-deprecated-declarations \
    --extra-arg=-Wno-unknown-warning-option --extra-arg=-Wno-ignored-gch 2> \
    >(grep -vE '^[0-9]+ warnings? (generated|treated)' >&2)
