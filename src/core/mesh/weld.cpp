// SPDX-License-Identifier: Apache-2.0
#include "myoface/mesh/weld.h"

#include <algorithm>
#include <numeric>

namespace myoface {

WeldedMesh weld(const TriangleMesh& mesh) {
    const int n = mesh.vertex_count();
    std::vector<int> order(static_cast<std::size_t>(n));
    std::iota(order.begin(), order.end(), 0);
    const auto key = [&](int v) {
        return std::tuple(mesh.vertices(0, v), mesh.vertices(1, v), mesh.vertices(2, v));
    };
    std::sort(order.begin(), order.end(),
              [&](int p, int q) { return std::tuple(key(p), p) < std::tuple(key(q), q); });
    std::vector<int> first(static_cast<std::size_t>(n));
    for (int i = 0; i < n; ++i) {
        const bool same = i > 0 && key(order[i]) == key(order[i - 1]);
        first[order[i]] = same ? first[order[i - 1]] : order[i];
    }

    WeldedMesh result;
    std::vector<Eigen::Vector3i> kept;
    std::vector<bool> used(static_cast<std::size_t>(n), false);
    for (int t = 0; t < mesh.triangle_count(); ++t) {
        const Eigen::Vector3i corners(first[mesh.triangles(0, t)], first[mesh.triangles(1, t)],
                                      first[mesh.triangles(2, t)]);
        const bool repeated =
            corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0];
        if (repeated || !(double_area_vector(mesh, t).squaredNorm() > 0.0)) {
            continue;
        }
        kept.push_back(corners);
        result.of_triangle.push_back(t);
        for (const int v : corners) {
            used[v] = true;
        }
    }

    std::vector<int> number(static_cast<std::size_t>(n), -1);
    int count = 0;
    for (int v = 0; v < n; ++v) {
        if (used[v]) {
            number[v] = count++;
        }
    }
    result.mesh.vertices.resize(3, count);
    result.of_vertex.resize(static_cast<std::size_t>(n));
    for (int v = 0; v < n; ++v) {
        result.of_vertex[v] = number[first[v]];
        if (number[v] >= 0) {
            result.mesh.vertices.col(number[v]) = mesh.vertices.col(v);
        }
    }
    result.mesh.triangles.resize(3, static_cast<Eigen::Index>(kept.size()));
    for (std::size_t t = 0; t < kept.size(); ++t) {
        for (int c = 0; c < 3; ++c) {
            result.mesh.triangles(c, static_cast<Eigen::Index>(t)) = number[kept[t][c]];
        }
    }
    return result;
}

}  // namespace myoface
