#!/bin/bash
# SPDX-License-Identifier: MIT
# SDR of voices by the files of configs/, tracks being found, in scenes at 16 kHz whose microphones are in our
# order:  scripts/score_scenes.sh ARRAY SCENE...
# ODAS's raw files come late by the look-back and by the frame. That is cut off here: no first or last word is lost.
set -euo pipefail
cd "$(dirname "$0")/.."
odas=${ODAS:-build/bin/odas}
array=$1
shift
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cp -r configs/common "$work"
for scene in "$@"; do
  mics=$(od -An -tu2 -j22 -N2 "$scene/mics.wav" | tr -d ' ')
  map=$(seq -s ', ' "$mics")
  sed -E "s/\bfS = [0-9]+/fS = 16000/; s/nChannels = [0-9]+/nChannels = $mics/; s/\bmap = \([^)]*\)/map = ($map)/
          /^ *reference = /d" "configs/$array.cfg" >"$work/array.cfg"
  "$odas" run "$scene/mics.wav" -c "$work/array.cfg" -o "$work/out" --odas-files >/dev/null
  bytes_in=$(($(stat -c %s "$scene/mics.wav") - 44))
  hops_in=$((bytes_in / (2 * mics * 128)))
  hops_out=$(wc -l <"$work/out/tracks.jsonl")
  bytes_out=$(stat -c %s "$work/out/separated.raw")
  late=$((bytes_out / hops_out * (hops_out - hops_in)))
  mkdir "$work/aligned"
  mv "$work/out/tracks.json" "$work/aligned"
  for stage in separated postfiltered; do
    tail -c +$((late + 1)) "$work/out/$stage.raw" >"$work/aligned/$stage.raw"
  done
  echo "$(basename "$scene"): $("$odas" score "$work/aligned" "$scene" | grep ' SDR')"
  rm -r "$work/out" "$work/aligned"
done
