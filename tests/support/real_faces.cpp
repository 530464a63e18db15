// SPDX-License-Identifier: Apache-2.0
#include "real_faces.h"

#include <cstdlib>

namespace myoface::test {

std::optional<std::filesystem::path> real_faces() {
    const char* given = std::getenv("MYOFACE_FACES");
    const std::filesystem::path folder = given != nullptr ? given : MYOFACE_SHARED_FACES;
    std::error_code error;
    if (std::filesystem::is_directory(folder / "faces", error)) {
        return folder;
    }
    return std::nullopt;
}

}  // namespace myoface::test
