// SPDX-License-Identifier: Apache-2.0
#include "myoface/mesh/vertex_triangles.h"

namespace myoface {

VertexTriangles::VertexTriangles(const TriangleMesh& mesh)
    : start_(static_cast<std::size_t>(mesh.vertex_count()) + 1, 0),
      triangle_(3 * static_cast<std::size_t>(mesh.triangle_count())) {
    for (int t = 0; t < mesh.triangle_count(); ++t) {
        for (int c = 0; c < 3; ++c) {
            ++start_[static_cast<std::size_t>(mesh.triangles(c, t)) + 1];
        }
    }
    for (std::size_t v = 1; v < start_.size(); ++v) {
        start_[v] += start_[v - 1];
    }
    std::vector<int> next(start_.begin(), start_.end() - 1);
    for (int t = 0; t < mesh.triangle_count(); ++t) {
        for (int c = 0; c < 3; ++c) {
            const auto v = static_cast<std::size_t>(mesh.triangles(c, t));
            triangle_[static_cast<std::size_t>(next[v]++)] = t;
        }
    }
}

}  // namespace myoface
