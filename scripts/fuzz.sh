#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Fuzzes the readers with Clang's libFuzzer under ASan and UBSan: scripts/fuzz.sh [SECONDS] [TARGET …]
# A finding stops the script; its input stays in build/fuzz/findings.
set -euo pipefail
cd "$(dirname "$0")/.."
seconds=${1:-60}
[ $# -gt 0 ] && shift
targets=("$@")
[ ${#targets[@]} -eq 0 ] && targets=(obj ply stl mtl interchange case plan landmarks journal atlas expression)
command -v clang++ >/dev/null || { echo "fuzz.sh: needs clang and libclang-rt-dev" >&2; exit 1; }
scripts/build.sh fuzz
build/fuzz/bin/write_seeds build/fuzz/seeds
mkdir -p build/fuzz/findings
for target in "${targets[@]}"; do
  mkdir -p "build/fuzz/corpus/$target"
  echo "fuzzing $target for $seconds s"
  build/fuzz/bin/fuzz_"$target" -max_total_time="$seconds" -timeout=5 -rss_limit_mb=1500 -max_len=8192 \
    -print_final_stats=1 -artifact_prefix="build/fuzz/findings/$target-" \
    "build/fuzz/corpus/$target" "build/fuzz/seeds/$target" 2>&1 |
    grep -E 'number_of_executed_units|ERROR|SUMMARY|runtime error|peak_rss'
done
