#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Looks for misspelt English words in sources, scripts and documents. Words that only look wrong stand below.
set -euo pipefail
cd "$(dirname "$0")/.."
known=trough,nd
git ls-files '*.md' '*.cpp' '*.h' '*.inc' '*.sh' '*.py' '*.cmake' '*.bib' '*.1' '*CMakeLists.txt' 'shaders/*' |
  xargs codespell --ignore-words-list "$known"
