// SPDX-License-Identifier: Apache-2.0
#include "fuzz_target.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    myoface::fuzz::read({reinterpret_cast<const char*>(data), size}, "f.obj");
    return 0;
}
