// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "myoface/base/points.h"

namespace myoface {

/// An indexed triangle mesh: 3×N vertices [mm] and 3×T triangles, counter-clockwise from outside.
struct TriangleMesh {
    Points vertices;
    Triangles triangles;

    int vertex_count() const { return static_cast<int>(vertices.cols()); }
    int triangle_count() const { return static_cast<int>(triangles.cols()); }
    Vec3 corner(int triangle, int corner) const {
        return vertices.col(triangles(corner, triangle));
    }
};

/// Twice the area vector of a triangle: its direction is the outward normal [mm²].
inline Vec3 double_area_vector(const TriangleMesh& mesh, int triangle) {
    const Vec3 a = mesh.corner(triangle, 0);
    return (mesh.corner(triangle, 1) - a).cross(mesh.corner(triangle, 2) - a);
}

/// A place on a mesh: a triangle and its barycentric weights (they sum to 1).
struct SurfacePoint {
    int triangle = -1;
    Vec3 weights = Vec3::Zero();
};

inline Vec3 position(const TriangleMesh& mesh, const SurfacePoint& point) {
    return mesh.corner(point.triangle, 0) * point.weights[0] +
           mesh.corner(point.triangle, 1) * point.weights[1] +
           mesh.corner(point.triangle, 2) * point.weights[2];
}

}  // namespace myoface
