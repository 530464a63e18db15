// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "myoface/io/scan.h"

namespace myoface {

enum class PlyType { Int8, Uint8, Int16, Uint16, Int32, Uint32, Float32, Float64 };

std::size_t size_of(PlyType type);

struct PlyProperty {
    std::string name;
    PlyType type = PlyType::Float32;
    bool is_list = false;
    PlyType count_type = PlyType::Uint8;
};

struct PlyElement {
    std::string name;
    std::size_t count = 0;
    std::vector<PlyProperty> properties;
};

struct PlyHeader {
    FileFormat format = FileFormat::PlyAscii;
    std::vector<PlyElement> elements;
    std::vector<std::string> textures;  ///< names after "comment TextureFile"
    std::size_t size = 0;               ///< bytes up to the first one of the body
};

/// Reads and checks a header: known types, sensible counts, no element twice, no count that the
/// rest of the file cannot hold. @throws IoError
PlyHeader read_ply_header(std::string_view bytes, const std::string& name);

}  // namespace myoface
