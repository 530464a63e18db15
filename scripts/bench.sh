#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Builds and runs the benchmarks: scripts/bench.sh [OUT.json] [--quick]; MYOFACE_BENCH_SCAN=FILE: a live
# drag on that scan too.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
out=${1:-bench.json}
repetitions=5
time_each=0.2
if [ "${2:-}" = --quick ]; then
  repetitions=3
  time_each=0.05
fi
"$here/setup.sh"
"$here/build.sh" release -DMYOFACE_BUILD_BENCH=ON
"$here/../build/release/bin/myoface-bench" --flat="$out" \
  --benchmark_min_time=$time_each --benchmark_repetitions=$repetitions
python3 "$here/bench_table.py" "$out" "$here/../docs/dev/performance.md"
echo "Medians and ratios: $out; table: docs/dev/performance.md"
