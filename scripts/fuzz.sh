#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Fuzzes the readers with Clang's libFuzzer under ASan and UBSan: scripts/fuzz.sh [SECONDS] [TARGET …]
# A finding stops the script; its input stays in build/asan/fuzz/findings.
set -euo pipefail
cd "$(dirname "$0")/.."
seconds=${1:-60}
[ $# -gt 0 ] && shift
targets=("$@")
[ ${#targets[@]} -eq 0 ] && targets=(obj ply stl mtl interchange case plan landmarks journal atlas expression)
command -v clang++ >/dev/null || { echo "fuzz.sh: needs clang and libclang-rt-dev" >&2; exit 1; }
MYOFACE_TARGETS=fuzz_targets scripts/build.sh asan
work=build/asan/fuzz
build/asan/bin/write_seeds "$work/seeds"
mkdir -p "$work/findings"
# @param 1 a target
fuzz() {
  mkdir -p "$work/corpus/$1"
  local said
  said=$(build/asan/bin/fuzz_"$1" -max_total_time="$seconds" -timeout=5 -rss_limit_mb=1500 -max_len=8192 \
    -print_final_stats=1 -artifact_prefix="$work/findings/$1-" "$work/corpus/$1" "$work/seeds/$1" 2>&1) ||
    { sed -n '/ERROR/,$p' <<<"$said" >&2; echo "fuzz.sh: a finding in $1" >&2; return 255; }
  echo "$1: $(sed -n 's/^stat::number_of_executed_units: *//p' <<<"$said") inputs in $seconds s, none of them bad"
}
export -f fuzz
export work seconds
printf '%s\n' "${targets[@]}" | xargs -P "$(nproc)" -I{} bash -c 'fuzz {}'
