// SPDX-License-Identifier: Apache-2.0
// What comes back from the import process may be anything.
#include <cstdlib>

#include "myoface/base/error.h"
#include "myoface/io/interchange.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    try {
        const myoface::Scan scan =
            myoface::decode_scan({reinterpret_cast<const char*>(data), size}, "f.glb");
        if (!scan.mesh.vertices.allFinite()) {
            std::abort();
        }
    } catch (const myoface::Error&) {
    }
    return 0;
}
