#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Builds the packages, unpacks the archive into a folder of its own and runs from there; installs
# the library beside it and builds a program that uses it: scripts/check_package.sh [FOLDER]; the packages
# are put into FOLDER. MYOFACE_PRESET says which build they are made of (release).
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
root=$(dirname "$here")
preset=${MYOFACE_PRESET:-release}
"$here/build.sh" "$preset"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

(cd "$root/build/$preset" && cpack -G "TGZ;DEB" -B "$work/packages" >/dev/null)
ls "$work"/packages/*.deb "$work"/packages/*.tar.gz
mkdir "$work/anywhere"
tar -xzf "$work"/packages/*.tar.gz -C "$work/anywhere" --strip-components=1
echo "The archive, from $work/anywhere:"
env -i PATH=/usr/bin:/bin HOME="$work" "$work/anywhere/bin/myoface-cli" simulate generic \
  --muscle zygomaticus_major=1 -o "$work/smile.obj" --report "$work/smile.json"
grep -q '"converged": true' "$work/smile.json"
env -i PATH=/usr/bin:/bin HOME="$work" QT_QPA_PLATFORM=offscreen \
  "$work/anywhere/bin/myoface" --version
# The package holds the same files, and says what it needs.
dpkg-deb -x "$work"/packages/*.deb "$work/deb"
env -i PATH=/usr/bin:/bin HOME="$work" "$work/deb/usr/bin/myoface-cli" info generic >/dev/null
dpkg-deb -f "$work"/packages/*.deb Depends | grep -q libqt5widgets5
for part in applications/myoface.desktop mime/packages/myoface.xml man/man1/myoface-cli.1 \
  bash-completion/completions/myoface-cli icons/hicolor/scalable/apps/myoface.svg; do
  test -s "$work/deb/usr/share/$part" || { echo "check_package.sh: $part is missing" >&2; exit 1; }
done

cmake --install "$root/build/$preset" --prefix "$work/prefix" >/dev/null
cmake -S "$root/tests/consumer" -B "$work/consumer" -DCMAKE_PREFIX_PATH="$work/prefix" \
  -DCMAKE_BUILD_TYPE=Release >/dev/null
cmake --build "$work/consumer" >/dev/null
MYOFACE_DATA="$work/prefix/share/myoface" "$work/consumer/consumer"
if [ -n "${1:-}" ]; then
  mkdir -p "$1"
  cp "$work"/packages/*.deb "$work"/packages/*.tar.gz "$1"
fi
echo "Packages, archive and library are good."
