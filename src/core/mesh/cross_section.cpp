// SPDX-License-Identifier: Apache-2.0
#include "myoface/mesh/cross_section.h"

#include <array>

namespace myoface {

std::vector<std::pair<Vec3, Vec3>> cross_section(const TriangleMesh& mesh, const Vec3& through,
                                                 const Vec3& normal) {
    std::vector<std::pair<Vec3, Vec3>> segments;
    for (int t = 0; t < mesh.triangle_count(); ++t) {
        std::array<double, 3> side{};
        int above = 0;
        for (int c = 0; c < 3; ++c) {
            side[static_cast<std::size_t>(c)] = normal.dot(mesh.corner(t, c) - through);
            above += side[static_cast<std::size_t>(c)] > 0.0;
        }
        if (above == 0 || above == 3) {
            continue;
        }
        // The corner that is alone on its side: both of its edges are cut.
        int alone = 0;
        while ((side[static_cast<std::size_t>(alone)] > 0.0) != (above == 1)) {
            ++alone;
        }
        const auto cut = [&](int other) {
            const double a = side[static_cast<std::size_t>(alone)];
            const double b = side[static_cast<std::size_t>(other)];
            return Vec3(mesh.corner(t, alone) +
                        a / (a - b) * (mesh.corner(t, other) - mesh.corner(t, alone)));
        };
        segments.emplace_back(cut((alone + 1) % 3), cut((alone + 2) % 3));
    }
    return segments;
}

}  // namespace myoface
