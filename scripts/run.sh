#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Sets up, builds and starts Myoface: scripts/run.sh [FACE]. The built-in face when none is named.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
"$here/setup.sh"
"$here/build.sh" release -DMYOFACE_BUILD_TESTS=OFF
exec "$here/../build/release/bin/myoface" "$@"
