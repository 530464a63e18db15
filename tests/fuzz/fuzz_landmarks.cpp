// SPDX-License-Identifier: Apache-2.0
#include "myoface/face/landmarks.h"

#include "fuzz_target.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace myoface;
    fuzz::guarded([&] {
        const LandmarkFile file =
            landmarks_from_json({reinterpret_cast<const char*>(data), size}, "f.json");
        for (const auto& [name, landmark] : file.landmarks) {
            fuzz::require(landmark.position.allFinite() && landmark.error_mm > 0.0);
        }
        landmarks_to_json(file.landmarks, {});
    });
    return 0;
}
