// SPDX-License-Identifier: Apache-2.0
#include <charconv>

#include "writers.h"

namespace myoface {

std::string stl_bytes(const Scan& scan, const Points& in_file) {
    const bool ascii = scan.format == FileFormat::StlAscii;
    const Eigen::Matrix3Xf points = in_file.cast<float>();
    const auto triangles = scan.mesh.triangle_count();
    ByteWriter bytes(false);
    const auto number = [&](float value) {
        if (!ascii) {
            bytes.add(value);
            return;
        }
        std::array<char, 32> buffer{};
        const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
        bytes.text.append(" ").append(buffer.data(), end.ptr);
    };
    const auto line = [&](const char* text) { bytes.text += ascii ? text : ""; };
    if (ascii) {
        bytes.text = "solid myoface\n";
    } else {
        bytes.text = kWrittenBy;
        bytes.text.resize(80, ' ');
        bytes.add(static_cast<std::uint32_t>(triangles));
    }
    for (int t = 0; t < triangles; ++t) {
        const std::array<int, 3> corners = in_file_order(corners_of(scan, t));
        std::array<Eigen::Vector3f, 3> p;
        for (std::size_t c = 0; c < 3; ++c) {
            p[c] = points.col(scan.faces.vertex[static_cast<std::size_t>(corners[c])]);
        }
        const Eigen::Vector3f normal = (p[1] - p[0]).cross(p[2] - p[0]).stableNormalized();
        line("facet normal");
        for (int axis = 0; axis < 3; ++axis) {
            number(normal.allFinite() ? normal[axis] : 0.0F);
        }
        line("\n outer loop\n");
        for (const Eigen::Vector3f& corner : p) {
            line("  vertex");
            for (int axis = 0; axis < 3; ++axis) {
                number(corner[axis]);
            }
            line("\n");
        }
        line(" endloop\nendfacet\n");
        if (!ascii) {
            bytes.add(std::uint16_t{0});
        }
    }
    line("endsolid myoface\n");
    return std::move(bytes.text);
}

}  // namespace myoface
