#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Walks through a consultation in the real window with a real mouse (xdotool) on a virtual display and keeps
# a picture of every step: scripts/window_walk.sh FOLDER [FACE]
set -euo pipefail
cd "$(dirname "$0")/.."
out=$(mkdir -p "$1" && cd "$1" && pwd)
face=${2:-generic}
program=$PWD/build/${MYOFACE_PRESET:-release}/bin/myoface
home=$(mktemp -d)
trap 'rm -rf "$home"' EXIT
export out face program
export XDG_CONFIG_HOME=$home/config XDG_DATA_HOME=$home/data QT_FONT_DPI=96

# shellcheck disable=SC2016
xvfb-run -a -s '-screen 0 1440x900x24 -dpi 96' bash -c '
set -euo pipefail
"$program" "$face" --size 1440x900 & pid=$!
trap "kill $pid 2>/dev/null || true" EXIT
shot() { sleep "${2:-1.5}"; import -window root "$out/$1.png"; }
key() { xdotool key --clearmodifiers "$@"; }
at() { xdotool mousemove "$1" "$2"; sleep 0.2; }
drag() {
  at "$1" "$2"; xdotool mousedown 1; sleep 0.3
  for k in 1 2 3 4 5 6 7 8; do
    xdotool mousemove $(($1 + k * $3 / 8)) $(($2 + k * $4 / 8)); sleep 0.12
  done
}
for _ in $(seq 60); do
  window=$(xdotool search --onlyvisible --name "Myoface" 2>/dev/null | head -n 1 || true)
  [ -n "$window" ] && break
  sleep 0.5
done
xdotool windowmove "$window" 0 0 windowsize "$window" 1440 900 windowfocus "$window"
shot 1-start 12
key alt+1; shot 2-scan
key alt+2; shot 3-fit
key alt+3
key ctrl+3; sleep 1                       # the profile
drag 528 528 -22 -14; shot 4-drag 0.6      # while the hand holds the nose
xdotool mouseup 1; shot 5-shaped 4
key ctrl+1; key e; at 610 560; shot 6-feel 2  # before, while the hand pulls, after
drag 610 560 70 -50; shot 7-pulled 1.5
xdotool mouseup 1; shot 8-released 4
key alt+4; shot 9-expression
key alt+5; key ctrl+alt+3; shot 10-wipe 2  # before and after
key ctrl+alt+5; shot 11-map 2
key ctrl+z; shot 12-undone 3
key ctrl+y; key alt+6; shot 13-report 3
key ctrl+k; sleep 0.7; xdotool type "side"; shot 14-search 0.7
key Escape
'
ls "$out"
