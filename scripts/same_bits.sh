#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Replays a plan by an optimised build and by a debug build of the same compiler, on one thread and on two:
# what comes out must be the same to the last bit. MYOFACE_PRESET names the optimised build (release).
set -euo pipefail
cd "$(dirname "$0")/.."
preset=${MYOFACE_PRESET:-release}
for build in "$preset" debug; do
  MYOFACE_TARGETS="myoface-cli myoface-import" scripts/build.sh "$build"
done
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
fast=build/$preset/bin/myoface-cli
"$fast" generate --vertices 3000 -o "$work/face.ply" --landmarks-out "$work/face.json" >/dev/null
cat >"$work/plan.json" <<'PLAN'
{"format": "myoface-plan", "schema": 1, "plan": [
 {"muscle": "zygomaticus_major.L", "rate": 0.5},
 {"drag": "at=prn; view=left; move=-3,4; mode=mouse"},
 {"drag": "at=ch_r; view=front; move=-2,1; mode=constraint; keep=1"},
 {"volume": "at=pg; ml=0.5"}]}
PLAN
for build in "$preset" debug; do
  for threads in 1 2; do
    "build/$build/bin/myoface-cli" replay "$work/plan.json" "$work/face.ply" --landmarks "$work/face.json" \
      --threads "$threads" -o "$work/$build-$threads.ply" --report "$work/$build-$threads.json" >/dev/null
    hash=$(grep -o '"state_hash": "[^"]*"' "$work/$build-$threads.json")
    echo "$build, $threads threads: $hash"
    [ "$hash" = "${first:=$hash}" ] && cmp "$work/$preset-1.ply" "$work/$build-$threads.ply" ||
      { echo "same_bits.sh: not the same" >&2; exit 1; }
  done
done
echo "The same bits."
