#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Every check there is, by hand, before a release: what continuous integration does, tidiness of all sources, longer fuzzing,
# the API reference, and the packages of a release build. About an hour and a half on two cores.
set -euo pipefail
cd "$(dirname "$0")/.."
export MYOFACE_LONG_TESTS=1
.ci/run
scripts/tidy.sh all
scripts/fuzz.sh 120
scripts/docs.sh
scripts/check_package.sh "$@"
