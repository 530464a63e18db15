// SPDX-License-Identifier: Apache-2.0
#include "myoface/mesh/cut.h"

#include <array>
#include <map>

namespace myoface {

SplitMesh split_along_zero(const TriangleMesh& mesh, const std::vector<double>& values,
                           const std::vector<bool>& part_of) {
    SplitMesh result;
    std::vector<Vec3> vertices;
    for (int v = 0; v < mesh.vertex_count(); ++v) {
        vertices.emplace_back(mesh.vertices.col(v));
    }
    result.values = values;
    std::map<std::pair<int, int>, int> middle;
    const auto cut = [&](int a, int b) {
        if (!part_of[a] || !part_of[b] || !(values[a] * values[b] < 0.0)) {
            return -1;
        }
        const auto key = std::minmax(a, b);
        const auto [found, fresh] = middle.try_emplace(key, static_cast<int>(vertices.size()));
        if (fresh) {
            const auto [p, q] = key;
            const double share = values[p] / (values[p] - values[q]);
            vertices.emplace_back((1.0 - share) * vertices[p] + share * vertices[q]);
            result.values.push_back(0.0);
        }
        return found->second;
    };
    std::vector<Eigen::Vector3i> triangles;
    for (int t = 0; t < mesh.triangle_count(); ++t) {
        const Eigen::Vector3i v = mesh.triangles.col(t);
        std::array<int, 3> on{};  // vertex on the edge opposite to corner c
        int cuts = 0;
        for (int c = 0; c < 3; ++c) {
            on[c] = cut(v[(c + 1) % 3], v[(c + 2) % 3]);
            cuts += on[c] >= 0 ? 1 : 0;
        }
        if (cuts == 0) {
            triangles.push_back(v);
        } else if (cuts == 1) {
            for (int c = 0; c < 3; ++c) {
                if (on[c] >= 0) {
                    triangles.emplace_back(v[c], v[(c + 1) % 3], on[c]);
                    triangles.emplace_back(v[c], on[c], v[(c + 2) % 3]);
                }
            }
        } else {  // two: the corner between them is alone on its side
            for (int c = 0; c < 3; ++c) {
                if (on[c] >= 0) {
                    continue;
                }
                const int alone = v[c];
                const int b = v[(c + 1) % 3];
                const int d = v[(c + 2) % 3];
                const int on_ab = on[(c + 2) % 3];
                const int on_ad = on[(c + 1) % 3];
                triangles.emplace_back(alone, on_ab, on_ad);
                if ((vertices[b] - vertices[on_ad]).norm() <
                    (vertices[d] - vertices[on_ab]).norm()) {
                    triangles.emplace_back(on_ab, b, on_ad);
                    triangles.emplace_back(b, d, on_ad);
                } else {
                    triangles.emplace_back(on_ab, b, d);
                    triangles.emplace_back(on_ab, d, on_ad);
                }
            }
        }
    }
    result.mesh.vertices.resize(3, static_cast<Eigen::Index>(vertices.size()));
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        result.mesh.vertices.col(static_cast<Eigen::Index>(i)) = vertices[i];
    }
    result.mesh.triangles.resize(3, static_cast<Eigen::Index>(triangles.size()));
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        result.mesh.triangles.col(static_cast<Eigen::Index>(i)) = triangles[i];
    }
    return result;
}

}  // namespace myoface
