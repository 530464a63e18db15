#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Builds the core by Clang under TSan and runs what works in several threads: loops, packed forces, the solver, levels,
# replay, the scan that follows and the journal.
set -euo pipefail
cd "$(dirname "$0")/.."
MYOFACE_TARGETS=myoface-race-tests scripts/build.sh tsan
filter='ParallelFor*:PackedModel*:EquilibriumSolver.H*:EquilibriumSolver.G*:LevelTransfer*:FollowingScan*:Plan.Replays*:SimulatedSkin.K*:Journal.Of*'
MYOFACE_THREADS=4 TSAN_OPTIONS=halt_on_error=1 build/tsan/bin/myoface-race-tests --gtest_brief=1 --gtest_filter="$filter"
echo "No data race was seen."
