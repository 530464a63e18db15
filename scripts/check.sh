#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Everything that continuous integration checks, and the packages: by hand, before a release.
set -euo pipefail
cd "$(dirname "$0")/.."
.ci/run
scripts/check_package.sh
