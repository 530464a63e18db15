#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Looks with clang-tidy at the sources that were changed since a commit: scripts/tidy.sh [COMMIT]
# Without one since the last; in a checkout without history there is nothing to look at. "all" takes every source.
set -euo pipefail
cd "$(dirname "$0")/.."
since=${1:-HEAD~1}
if [ "$since" = all ]; then
  mapfile -t files < <(git ls-files 'src/*.cpp')
elif git rev-parse --verify --quiet "$since^{commit}" >/dev/null; then
  mapfile -t files < <(git diff --name-only --diff-filter=d "$since" -- 'src/*.cpp')
else
  files=()
fi
if [ ${#files[@]} -eq 0 ]; then
  echo "No source was changed."
  exit 0
fi
# Clang has no say in the kernels of other instructions and need not know how the folders are configured.
cflags=$(pkg-config --cflags eigen3 Qt5Widgets Qt5Svg epoxy glfw3 libzip)
read -ra libraries <<<"${cflags//-I/-isystem }"
flags=(-std=c++20 -fPIC -mavx2 -Iinclude -Isrc/core -Isrc/render -Isrc/words -Isrc/report -Isrc/app -DQT_NO_KEYWORDS
  -DMYOFACE_SOURCE_DIR='"."' -DMYOFACE_DATA_DIR='"."' -DMYOFACE_VERSION='"0"' "${libraries[@]}")
printf '%s\n' "${files[@]}" |
  xargs -P "$(nproc)" -I{} clang-tidy --quiet --warnings-as-errors='*' {} -- "${flags[@]}" 2> >(grep -v 'warnings\? \(generated\|treated\)' >&2)
echo "clang-tidy has nothing to say of ${#files[@]} sources."
