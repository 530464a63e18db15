// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "myoface/io/scan.h"

namespace myoface {

inline constexpr const char* kWrittenBy =
    "Written by Myoface. A planning aid, not a medical device.";

/// A file and what is to stand in it.
struct OutputFile {
    std::filesystem::path file;
    std::string bytes;
};

/// All write the scan's faces as they came with `in_file` for vertices (file's unit and axes).
std::string obj_text(const Scan& scan, const Points& in_file, const std::string& library);
std::string ply_bytes(const Scan& scan, const Points& in_file);
std::string stl_bytes(const Scan& scan, const Points& in_file);
std::string glb_bytes(const Scan& scan, const Points& in_file);

/// An OBJ's material library; `textures` holds the names that the pictures have beside it.
std::string mtl_text(const Scan& scan, const std::vector<std::string>& textures);

/// Appends numbers in a fixed byte order.
class ByteWriter {
public:
    explicit ByteWriter(bool big) : swap_((std::endian::native == std::endian::big) != big) {}

    template <typename T>
    void add(T value) {
        auto raw = std::bit_cast<std::array<char, sizeof(T)>>(value);
        if (swap_) {
            std::reverse(raw.begin(), raw.end());
        }
        text.append(raw.data(), raw.size());
    }

    std::string text;

private:
    bool swap_;
};

/// A triangle's corners in the file's own winding, also where it was turned for computing.
inline std::array<int, 3> in_file_order(std::array<int, 3> corners) {
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    if (corners[1] > corners[2]) {
        std::swap(corners[1], corners[2]);
    }
    return corners;
}

inline std::uint8_t byte_of(float colour) {
    return static_cast<std::uint8_t>(std::lround(std::clamp(colour, 0.0F, 1.0F) * 255.0F));
}

}  // namespace myoface
