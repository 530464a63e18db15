#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Every check there is, by hand, before a release: what continuous integration does, tidiness of all sources, longer
# fuzzing, equality of builds, the API reference, and the packages of a release build. About two hours on two cores.
set -euo pipefail
cd "$(dirname "$0")/.."
export MYOFACE_LONG_TESTS=1
.ci/run
scripts/tidy.sh all
scripts/fuzz.sh 120
scripts/same_bits.sh
scripts/docs.sh
scripts/check_package.sh "$@"
