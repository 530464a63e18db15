// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdlib>

namespace myoface::test {

/// MYOFACE_LONG_TESTS=1: more people, more places, more rounds, as before a release
/// (scripts/check.sh). Without it every test still does the same work, on less of it.
inline bool thorough() {
    return std::getenv("MYOFACE_LONG_TESTS") != nullptr;
}

}  // namespace myoface::test
