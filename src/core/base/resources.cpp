// SPDX-License-Identifier: Apache-2.0
#include "myoface/base/resources.h"

#include <cstdlib>
#include <vector>

#include "myoface/base/error.h"

namespace myoface {

std::filesystem::path resource_path(const std::string& name) {
    std::vector<std::filesystem::path> folders;
    if (const char* given = std::getenv("MYOFACE_DATA")) {
        folders.emplace_back(given);
    }
    std::error_code error;
    const auto program = std::filesystem::read_symlink("/proc/self/exe", error);
    if (!error) {
        folders.push_back(program.parent_path().parent_path() / "share/myoface");
    }
    folders.emplace_back(MYOFACE_SOURCE_DIR);
    folders.emplace_back(MYOFACE_DATA_DIR);  // of programs that link the installed library
    for (const auto& folder : folders) {
        if (std::filesystem::is_regular_file(folder / name, error)) {
            return folder / name;
        }
    }
    throw IoError("The program's own file " + name +
                  " is missing; reinstall it or set MYOFACE_DATA to its folder.");
}

}  // namespace myoface
