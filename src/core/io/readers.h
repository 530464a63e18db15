// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "myoface/base/progress.h"
#include "myoface/io/scan.h"

namespace myoface {

/// All fill vertices (file's own unit and axes), faces, colours, UV, materials and texture names;
/// triangles follow later. `name` is the file's name for messages. @throws IoError
void read_obj(std::string_view text, const std::string& name, Scan& scan, const Progress* progress);
void read_ply(std::string_view bytes, const std::string& name, Scan& scan,
              const Progress* progress);
void read_stl(std::string_view bytes, const std::string& name, Scan& scan,
              const Progress* progress);
/// glTF and GLB, in a process of its own. @throws IoError, Cancelled
void read_gltf(const std::filesystem::path& file, Scan& scan, const Progress* progress);

bool stl_is_binary(std::string_view bytes);

/// Looks up an OBJ's material libraries and all textures beside the file. What is missing or
/// unreadable stays without.
void read_materials(const std::filesystem::path& folder, Scan& scan);

/// A file that another file names: the regular file of that name inside the same folder or below
/// it, also where the name has backslashes, other letter case or the folders of another computer.
std::optional<std::filesystem::path> companion(const std::filesystem::path& folder,
                                               std::string name);

}  // namespace myoface
