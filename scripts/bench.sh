#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Builds and runs the benchmarks: scripts/bench.sh [OUT.json] [--quick]
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
out=${1:-bench.json}
time_each=0.5
[ "${2:-}" = --quick ] && time_each=0.1
"$here/setup.sh"
"$here/build.sh" release -DMYOFACE_BUILD_BENCH=ON
"$here/../build/release/bin/myoface-bench" --benchmark_min_time=$time_each --benchmark_out="$out" --benchmark_out_format=json
