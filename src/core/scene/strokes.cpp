// SPDX-License-Identifier: Apache-2.0
#include "myoface/scene/strokes.h"

#include <algorithm>
#include <cstdint>

namespace myoface {

void add_line(LineLayer& lines, const std::vector<Vec3>& points, const Eigen::Vector3f& colour) {
    const Eigen::Index first = lines.positions.cols();
    const auto count = static_cast<Eigen::Index>(points.size());
    lines.positions.conservativeResize(3, first + count);
    lines.colours.conservativeResize(3, first + count);
    for (Eigen::Index k = 0; k < count; ++k) {
        lines.positions.col(first + k) = points[static_cast<std::size_t>(k)].cast<float>();
        lines.colours.col(first + k) = colour;
        if (k > 0) {
            lines.indices.push_back(static_cast<std::uint32_t>(first + k - 1));
            lines.indices.push_back(static_cast<std::uint32_t>(first + k));
        }
    }
}

void add_arrow(LineLayer& lines, const Vec3& from, const Vec3& way, const Vec3& view,
               const Eigen::Vector3f& colour) {
    if (!(way.norm() > 0.5)) {
        return;
    }
    const Vec3 tip = from + way;
    const Vec3 side = way.cross(view).normalized();
    const double head = std::min(4.0, 0.35 * way.norm());
    const Vec3 back = -head * way.normalized();
    add_line(lines, {from, tip}, colour);
    add_line(lines, {tip + back + 0.5 * head * side, tip, tip + back - 0.5 * head * side}, colour);
}

}  // namespace myoface
