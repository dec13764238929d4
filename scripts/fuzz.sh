#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# scripts/fuzz.sh BUILD SECONDS [NAME...]: runs the fuzzers NAME (all, where none is named) of a build, each for so
# long, as many at once as there are cores. What they find new is kept in BUILD/corpus, what breaks in BUILD.
set -euo pipefail
source=$(cd "$(dirname "$0")/.." && pwd)
build=$(cd "$1" && pwd)
seconds=$2
shift 2
names=("$@")
if ((${#names[@]} == 0)); then
  for program in "$build"/bin/*_fuzz; do names+=("$(basename "$program" _fuzz)"); done
fi

run() {
  local name=$1 found=$build/corpus/$1
  mkdir -p "$found"
  "$build/bin/${name}_fuzz" -max_total_time="$seconds" -timeout=20 -rss_limit_mb=2048 -max_len=8192 \
    -print_final_stats=1 -verbosity=1 -artifact_prefix="$build/$name-" "$found" "$source/tests/fuzz/corpus/$name" \
    >"$found.log" 2>&1 || { tail -40 "$found.log"; echo "fuzz: $name broke; its input is $build/$name-*"; return 1; }
  echo "fuzz: $name: $(sed -n 's/^stat::number_of_executed_units: *//p' "$found.log") inputs in $seconds s, none broke it"
}
export -f run
export source build seconds
# shellcheck disable=SC2016  # it is the inner shell's $1
printf '%s\0' "${names[@]}" | xargs -0 -n 1 -P "$(nproc)" bash -c 'run "$1"' _
