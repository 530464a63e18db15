// SPDX-License-Identifier: Apache-2.0
#include "myoface/face/muscle_atlas.h"

#include "fuzz_target.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace myoface;
    fuzz::guarded([&] {
        for (const AtlasMuscle& muscle :
             muscle_atlas_from_json({reinterpret_cast<const char*>(data), size})) {
            fuzz::require(muscle.path.allFinite() && muscle.path.cols() >= 2);
        }
    });
    return 0;
}
