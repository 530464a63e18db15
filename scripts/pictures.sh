#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Makes the manual's pictures with the program: scripts/pictures.sh [SCAN.obj]
# Without a scan only those of the built-in face are made.
set -euo pipefail
cd "$(dirname "$0")/.."
bin=build/${MYOFACE_PRESET:-release}/bin
out=docs/user/pictures
export QT_FONT_DPI=96 MYOFACE_NO_MULTISAMPLING=
size=640x720
draw() { "$bin/myoface-cli" render "$@"; }
draw generic --size $size --view three-quarter-left -o $out/generic.png
draw generic --size $size --view three-quarter-left --layers muscle,bone -o $out/layers.png
draw generic --size $size --layers muscle,bone -o $out/atlas-front.png
draw generic --size $size --layers muscle,bone --view left -o $out/atlas-side.png
draw generic --size $size --layers skin,muscle,bone --skin-opacity 1 --cut-away 0.5 --view three-quarter-left -o $out/atlas-cut.png
draw generic --size $size --layers springs -o $out/atlas-springs.png

# Women and men of three ages, close-ups and what the muscles do: two sheets put together by ImageMagick.
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
for sex in f m; do
  for age in 25 50 78; do
    "$bin/myoface-cli" generate --sex $sex --age $age --vertices 30000 -o "$work/$sex$age.obj" \
      --landmarks-out "$work/$sex$age.landmarks.json"
    draw "$work/$sex$age.obj" --size 460x520 --view front -o "$work/$sex$age-front.png"
    draw "$work/$sex$age.obj" --size 460x520 --view three-quarter-left -o "$work/$sex$age-turned.png"
  done
done
montage "$work"/{f,m}{25,50,78}-{front,turned}.png -tile 6x2 -geometry +2+2 "$work/people.png"
convert "$work/people.png" -resize 1500x -quality 90 $out/people.jpg
face=$work/f25.obj
close() { draw "$face" --size 460x460 --focus "$1" --span "$2" --view "$3" -o "$work/close-$1-$3.png"; }
close ex_l 62 three-quarter-left
close prn 70 three-quarter-left
close prn 70 below
close sto 76 front
close t_l 96 left
montage "$work"/close-*.png -tile 5x1 -geometry +2+2 "$work/close.png"
convert "$work/close.png" -resize 1500x -quality 90 $out/close-ups.jpg
act() { local name=$1; shift; draw "$face" --size 460x520 "$@" -o "$work/act-$name.png"; }
act 1-rest
act 2-smile --muscle zygomaticus_major=0.8 --muscle orbicularis_oculi_orbital=0.5 --muscle risorius=0.2
act 3-frown --muscle corrugator_supercilii=1 --muscle procerus=1 --muscle depressor_anguli_oris=0.6
act 4-eyes-closed --muscle orbicularis_oculi_palpebral=1
act 5-mouth-open --muscle jaw_opening=0.8
montage "$work"/act-*.png -tile 5x1 -geometry +2+2 "$work/acts.png"
convert "$work/acts.png" -resize 1500x -quality 90 $out/actions.jpg

presets="joy sadness surprise fear anger disgust contempt gentle_smile full_smile brow_raise frown eyes_closed \
  eyes_tight snarl pucker show_teeth jaw_open vowel_a vowel_e vowel_i vowel_o vowel_u"
# A contact sheet: contact NAME FACE [options]
contact() {
  local name=$1 of=$2 shown=()
  shift 2
  for preset in $presets; do
    draw "$of" --size 300x350 --expression "$preset=1" "$@" -o "$work/$name-$preset.png"
    shown+=("$work/$name-$preset.png")
  done
  montage "${shown[@]}" -tile 6x4 -geometry +2+2 "$work/$name.png"
  convert "$work/$name.png" -resize 1500x -quality 88 "$out/$name.jpg"
}
contact expressions "$face" --skin-age 25
contact expressions-man "$work/m50.obj" --skin-age 50

# What shortened skin does at 60.
shown=()
"$bin/myoface-cli" generate --vertices 65000 -o "$work/fine.ply" --landmarks-out "$work/fine.landmarks.json"
for what in full_smile:sn:116 frown:g:84 eyes_tight:ex_l:76; do
  IFS=: read -r preset where span <<<"$what"
  draw "$work/fine.ply" --size 560x480 --skin-age 60 --expression "$preset=1" --focus "$where" --span "$span" \
    -o "$work/wrinkle-$preset.png"
  shown+=("$work/wrinkle-$preset.png")
done
convert "${shown[@]}" +append -quality 90 $out/wrinkles.jpg

"$bin/myoface-cli" generate --seed 12 --sex m --age 41 --vertices 14000 --asymmetry 1.2 -o "$work/person.ply"
xvfb-run -a -s '-screen 0 1600x1000x24' "$bin/myoface" "$work/person.ply" --landmarks-panel --screenshot $out/landmarks.png

window() { xvfb-run -a -s '-screen 0 1600x1000x24 -dpi 96' "$bin/myoface" "$@"; }
window generic --size 1280x760 --language ja --theme light --step shape --screenshot $out/window-japanese.png

window generic --size 1280x760 --views 4 --step shape --screenshot $out/window-views.png
window generic --size 1280x760 --expression full_smile=1 --step shape --section ls --screenshot $out/window-section.png

[ $# -ge 1 ] || exit 0
scan=$1
"$bin/myoface-cli" render "$scan" --size $size -o $out/scan-before.png
"$bin/myoface-cli" render "$scan" --size $size --muscle zygomaticus_major=1 -o $out/scan-smile.png
"$bin/myoface-cli" render "$scan" --size $size --view left -o $out/drag-before.png
"$bin/myoface-cli" render "$scan" --size $size --view left --drag "at=prn; view=left; move=-3,4" -o $out/drag-after.png
xvfb-run -a -s '-screen 0 1600x1000x24' "$bin/myoface" "$scan" --muscle zygomaticus_major=0.8 \
  --layers skin,muscle,bone --view three-quarter-left --step expression --size 1440x900 --screenshot $out/window-scan.png
window "$scan" --size 1280x760 --expression full_smile=0.9 --step compare --compare wipe --screenshot $out/window-compare.png
contact expressions-scan "$scan"
scripts/window_walk.sh "$work/walk" "$scan"
convert "$work/walk/4-drag.png" -resize 1200x $out/window-shape.png
montage "$work"/walk/{2-scan,3-fit,5-shaped,7-pulled,8-released,9-expression,10-wipe,11-map,13-report}.png -tile 3x3 -geometry 640x400+3+3 "$work/walk.png"
convert "$work/walk.png" -quality 88 $out/walk.jpg
