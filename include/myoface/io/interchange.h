// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "myoface/io/scan.h"

namespace myoface {

/// A scan as bytes between two processes of one program on one machine: vertices, faces, colours,
/// UV, materials, textures and format, in native byte order. Not a file format.
std::string encode_scan(const Scan& scan);

/// The way back, believing nothing: sizes, indices and numbers are checked.
/// @throws IoError, `name` in its words
Scan decode_scan(std::string_view bytes, const std::string& name);

}  // namespace myoface
