// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

namespace myoface {

/// Full path of a file that comes with the program, such as "shaders/skin.vert". Looked for in the
/// folder named by MYOFACE_DATA, in ../share/myoface beside the program, and in the source tree.
/// @throws IoError when it is nowhere
std::filesystem::path resource_path(const std::string& name);

}  // namespace myoface
