#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Builds the core under TSan and runs what works in several threads: loops, packed forces, the solver, levels,
# drags and the journal.
set -euo pipefail
cd "$(dirname "$0")/.."
scripts/build.sh tsan
filter='ParallelFor*:PackedModel*:EquilibriumSolver.H*:LevelTransfer*:FollowingScan*:Plan.Replays*:SimulatedSkin.K*:Journal.Of*'
TSAN_OPTIONS=halt_on_error=1 build/tsan/bin/myoface-core-tests --gtest_brief=1 --gtest_filter="$filter"
echo "No data race was seen."
