// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "myoface/mesh/triangle_mesh.h"

namespace myoface {

/// A mesh that grows.
struct MeshBuilder {
    std::vector<Vec3> vertices;
    std::vector<Eigen::Vector3i> triangles;

    MeshBuilder() = default;
    explicit MeshBuilder(const TriangleMesh& mesh) {
        vertices.reserve(static_cast<std::size_t>(mesh.vertex_count()));
        for (int v = 0; v < mesh.vertex_count(); ++v) {
            vertices.emplace_back(mesh.vertices.col(v));
        }
        triangles.reserve(static_cast<std::size_t>(mesh.triangle_count()));
        for (int t = 0; t < mesh.triangle_count(); ++t) {
            triangles.emplace_back(mesh.triangles.col(t));
        }
    }

    int add(const Vec3& p) {
        vertices.push_back(p);
        return static_cast<int>(vertices.size()) - 1;
    }

    /// Two triangles for a-b-c-d in order.
    void add_quad(int a, int b, int c, int d) {
        triangles.emplace_back(a, b, c);
        triangles.emplace_back(a, c, d);
    }

    TriangleMesh mesh() const {
        TriangleMesh result;
        result.vertices.resize(3, static_cast<Eigen::Index>(vertices.size()));
        for (std::size_t v = 0; v < vertices.size(); ++v) {
            result.vertices.col(static_cast<Eigen::Index>(v)) = vertices[v];
        }
        result.triangles.resize(3, static_cast<Eigen::Index>(triangles.size()));
        for (std::size_t t = 0; t < triangles.size(); ++t) {
            result.triangles.col(static_cast<Eigen::Index>(t)) = triangles[t];
        }
        return result;
    }
};

}  // namespace myoface
