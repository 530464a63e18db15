// SPDX-License-Identifier: Apache-2.0
// A case as bytes, or, since a zip keeps sums that nobody guesses, its parts one after the other:
// manifest, shape, protection and first variant, between bytes 0xFF.
#include "cases/archive.h"
#include "cases/case_bytes.h"
#include "fuzz_target.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace myoface;
    const std::string_view input(reinterpret_cast<const char*>(data), size);
    fuzz::guarded([&] {
        std::string packed;
        if (input.substr(0, 2) != "PK") {
            std::vector<ZipPart> parts{{"scan", "v 0 0 0\nv 200 0 0\nv 0 200 0\nf 1 2 3\n"}};
            std::size_t at = 0;
            for (const char* name : {"manifest.json", "shape", "protection", "variant-0"}) {
                const std::size_t end = std::min(input.find('\xff', at), size);
                parts.push_back({name, input.substr(std::min(at, size), end - std::min(at, size))});
                at = end + 1;
            }
            packed = zip_bytes(parts, {}, "f");
        }
        const OpenedFace face = read_case_bytes(packed.empty() ? input : packed, "f.myoface");
        fuzz::require(face.state.shape.allFinite() && face.scan->mesh.vertices.allFinite());
        to_parts(face.state);
    });
    return 0;
}
