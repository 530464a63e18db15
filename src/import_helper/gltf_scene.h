// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "myoface/io/scan.h"

namespace myoface {

/// Reads a glTF or GLB file: all its triangles with the transforms of their nodes, colours, one set
/// of texture coordinates, materials, textures inside the file. Opens nothing outside its folder.
/// @throws IoError with what is wrong, without the file's name
Scan read_gltf_scene(const std::filesystem::path& file);

}  // namespace myoface
