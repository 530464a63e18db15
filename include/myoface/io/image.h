// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace myoface {

/// 8-bit RGBA picture, rows from top to bottom.
struct Image {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> rgba;
};

/// Reads PNG or JPEG, told apart by content; at most 16384 × 16384 pixels.
/// @throws IoError
Image read_image(const std::filesystem::path& file);

/// The same from memory; `name` stands in messages. @throws IoError
Image read_image_bytes(const std::string& bytes, const std::string& name);

/// A JPEG of the picture, opacity left out. @param quality 1 … 100
std::string encode_jpeg(const Image& image, int quality);

/// Writes a PNG, whole or not at all. @throws IoError
void write_png(const std::filesystem::path& file, const Image& image);

}  // namespace myoface
