#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Writes the API reference of the public headers to build/docs/html (Doxygen). A warning is an error.
set -euo pipefail
cd "$(dirname "$0")/.."
command -v doxygen >/dev/null || { echo "docs.sh: needs doxygen" >&2; exit 1; }
mkdir -p build/docs
scripts/references.py >build/docs/references.md
doxygen docs/dev/Doxyfile
echo "Read build/docs/html/index.html"
