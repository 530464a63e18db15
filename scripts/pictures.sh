#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Makes the manual's pictures with the program: scripts/pictures.sh [SCAN.obj]
# Without a scan only those of the built-in face are made.
set -euo pipefail
cd "$(dirname "$0")/.."
bin=build/release/bin
out=docs/user/pictures
export QT_FONT_DPI=96 MYOFACE_NO_MULTISAMPLING=
size=640x720
"$bin/myoface-cli" render generic --size $size --view three-quarter-left -o $out/generic.png
"$bin/myoface-cli" render generic --size $size --view three-quarter-left --layers muscle,bone -o $out/layers.png
[ $# -ge 1 ] || exit 0
scan=$1
"$bin/myoface-cli" render "$scan" --size $size -o $out/scan-before.png
"$bin/myoface-cli" render "$scan" --size $size --muscle zygomaticus_major=1 -o $out/scan-smile.png
"$bin/myoface-cli" render "$scan" --size $size --view left -o $out/drag-before.png
"$bin/myoface-cli" render "$scan" --size $size --view left --drag "at=prn; view=left; move=-3,4" -o $out/drag-after.png
xvfb-run -a -s '-screen 0 1600x1000x24' "$bin/myoface" "$scan" --muscle zygomaticus_major=0.8 \
  --layers skin,muscle,bone --view three-quarter-left --screenshot $out/window-scan.png
