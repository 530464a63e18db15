#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Sets up, builds and runs all tests; those that draw run under a virtual display.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
"$here/setup.sh"
"$here/build.sh" dev -DMYOFACE_BUILD_TESTS=ON
cd "$here/.."
QT_FONT_DPI=96 xvfb-run -a -s '-screen 0 1600x1000x24 -dpi 96' \
  ctest --test-dir build/dev --output-on-failure --no-tests=error -j "$(nproc)" "$@"
