// SPDX-License-Identifier: Apache-2.0
// A material library beside a small OBJ file.
#include <filesystem>
#include <unistd.h>

#include "myoface/base/error.h"
#include "myoface/io/mesh_file.h"
#include "myoface/io/text_file.h"

namespace {

const std::filesystem::path& folder() {
    static const std::filesystem::path kFolder = [] {
        const auto path =
            std::filesystem::temp_directory_path() / ("myoface-fuzz-" + std::to_string(::getpid()));
        std::filesystem::create_directories(path);
        myoface::write_file(path / "skin.png", "x");
        return path;
    }();
    return kFolder;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    myoface::write_file(folder() / "f.mtl", {reinterpret_cast<const char*>(data), size});
    myoface::Scan scan;
    scan.materials = {{"a", {}, -1}, {"b c", {}, -1}};
    scan.material_libraries = {"f.mtl"};
    try {
        myoface::read_companions(folder() / "f.obj", scan);
    } catch (const myoface::Error&) {
    }
    return 0;
}
