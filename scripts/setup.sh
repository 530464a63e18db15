#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Installs from Debian or Ubuntu what building and testing needs and is missing. Silent when nothing
# is missing; needs root or sudo only when something is. Names of more packages may follow.
set -euo pipefail

packages=(
  build-essential cmake ninja-build pkg-config file
  qtbase5-dev libqt5svg5-dev
  libeigen3-dev libglfw3-dev libepoxy-dev libegl-dev
  nlohmann-json3-dev libcli11-dev libpng-dev libjpeg-dev libzip-dev zlib1g-dev libassimp-dev libnanoflann-dev
  libgtest-dev libgmock-dev libbenchmark-dev libtinyobjloader-dev libbullet-dev
  python3 xvfb xauth libgl1-mesa-dri libegl1 fonts-dejavu-core fonts-ipafont-gothic clang-format
  "$@"
)

missing=()
for package in "${packages[@]}"; do
  if ! dpkg-query -W -f '${Status}' "$package" 2>/dev/null | grep -q 'ok installed'; then
    # A virtual package counts when something that provides it is there.
    if [ "$package" = libjpeg-dev ] && dpkg-query -W libjpeg62-turbo-dev >/dev/null 2>&1; then
      continue
    fi
    missing+=("$package")
  fi
done
[ ${#missing[@]} -eq 0 ] && exit 0

if ! command -v apt-get >/dev/null; then
  echo "setup.sh: this script knows Debian and Ubuntu; install by hand: ${missing[*]}" >&2
  exit 1
fi
as_root=()
if [ "$(id -u)" -ne 0 ]; then
  if ! command -v sudo >/dev/null; then
    echo "setup.sh: run as root, or install sudo, to install: ${missing[*]}" >&2
    exit 1
  fi
  as_root=(sudo)
fi
echo "Installing: ${missing[*]}"
"${as_root[@]}" apt-get update -qq
DEBIAN_FRONTEND=noninteractive "${as_root[@]}" apt-get install -y -qq --no-install-recommends "${missing[@]}" >/dev/null
