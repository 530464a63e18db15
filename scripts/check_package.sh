#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Builds the packages, unpacks the archive into a folder of its own and runs from there; installs
# the library beside it and builds a program that uses it. Leaves nothing behind but the packages.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
root=$(dirname "$here")
"$here/build.sh" release
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

(cd "$root/build/release" && cpack -G "TGZ;DEB" -B "$work/packages" >/dev/null)
ls "$work"/packages/*.deb "$work"/packages/*.tar.gz
mkdir "$work/anywhere"
tar -xzf "$work"/packages/*.tar.gz -C "$work/anywhere" --strip-components=1
echo "The archive, from $work/anywhere:"
env -i PATH=/usr/bin:/bin HOME="$work" "$work/anywhere/bin/myoface-cli" simulate generic \
  --muscle zygomaticus_major=1 -o "$work/smile.obj" --report "$work/smile.json"
grep -q '"converged": true' "$work/smile.json"
env -i PATH=/usr/bin:/bin HOME="$work" QT_QPA_PLATFORM=offscreen \
  "$work/anywhere/bin/myoface" --version

cmake --install "$root/build/release" --prefix "$work/prefix" >/dev/null
cmake -S "$root/tests/consumer" -B "$work/consumer" -DCMAKE_PREFIX_PATH="$work/prefix" \
  -DCMAKE_BUILD_TYPE=Release >/dev/null
cmake --build "$work/consumer" >/dev/null
MYOFACE_DATA="$work/prefix/share/myoface" "$work/consumer/consumer"
if [ -n "${1:-}" ]; then
  mkdir -p "$1"
  cp "$work"/packages/*.deb "$work"/packages/*.tar.gz "$1"
fi
echo "Packages, archive and library are good."
