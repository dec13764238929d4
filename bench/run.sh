#!/bin/sh
# SPDX-License-Identifier: MIT
# Prints what odas costs: time per hop and stage, then instructions per second of sound and start-up.
# usage: bench/run.sh BUILD_DIR
set -eu
build=$(cd "${1:-build}" && pwd)
source=$(cd "$(dirname "$0")/.." && pwd)

"$build/bin/odas_bench" --benchmark_min_time=0.2

command -v valgrind >/dev/null || { echo "valgrind is not installed: no count of instructions"; exit 0; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# instructions SECONDS: of odaslive over so much of the recording in $work
instructions() {
  bytes=$(($1 * 16000 * 2 * channels))
  head -c "$bytes" "$work/whole.raw" >"$work/mics.raw"
  (cd "$work" && valgrind --tool=callgrind --callgrind-out-file=/dev/null "$build/bin/odaslive" -s -c odas.cfg 2>&1 >/dev/null) |
    sed -n 's/.*Collected : //p'
}

# row SCENE CONFIGURATION
row() {
  cp "$scenes/$1/odas/$2" "$work/odas.cfg"
  channels=$(sed -n 's/.*nChannels *= *\([0-9]*\).*/\1/p' "$work/odas.cfg" | head -n 1)
  three=$(instructions 3)
  nine=$(instructions 9)
  slope=$(((nine - three) / 6))
  printf '%-18s %-14s %6s %20s %20s\n' "$1" "$2" "$channels" "$((slope / 1000000))" "$(((three - 3 * slope) / 1000000))"
}

echo
echo "Million instructions of odaslive -s (callgrind): per second of sound (slope from 3 s to 9 s), and to start"
printf '%-18s %-14s %6s %20s %20s\n' recording configuration mics "per second of sound" "start-up"
scenes=${ODAS_SHARED:-$source/../shared}/scenes
if [ -d "$scenes" ]; then
  for scene in rsp4_static2 uma7_static4 oma16_static2 cma16_static2; do
    wav=$scenes/$scene/mics.wav
    data=$(LC_ALL=C grep -abo -m 1 data "$wav" | head -n 1 | cut -d: -f1)
    tail -c +$((data + 9)) "$wav" >"$work/whole.raw"
    row "$scene" dds_only.cfg
    row "$scene" odas.cfg
  done
else
  echo "(no ../shared/scenes here)"
fi
