// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "myoface/base/view_ray.h"
#include "myoface/mesh/triangle_mesh.h"

namespace myoface {

struct ClosestPoint {
    SurfacePoint where;
    Vec3 point = Vec3::Zero();
    double distance = 0.0;  ///< [mm]
};

struct RayHit {
    SurfacePoint where;
    double distance = 0.0;  ///< along the ray [mm]
};

/// Bounding-volume hierarchy over the triangles of a mesh. It keeps no copy of the mesh: pass the
/// mesh it was built for, and call refit() after its vertices have moved.
class Bvh {
public:
    Bvh() = default;
    explicit Bvh(const TriangleMesh& mesh);

    /// Updates the boxes to moved vertices; the tree's shape stays.
    void refit(const TriangleMesh& mesh);

    /// Nearest point of the mesh; ties go to the lower triangle number.
    /// @param within what is known to be no nearer than the nearest point [mm]: saves looking
    /// @pre the mesh has a triangle.
    ClosestPoint closest_point(const TriangleMesh& mesh, const Vec3& query,
                               double within = std::numeric_limits<double>::infinity()) const;

    /// First triangle hit from either side.
    std::optional<RayHit> first_hit(const TriangleMesh& mesh, const ViewRay& ray) const;

private:
    struct Node {
        Eigen::AlignedBox3d box;
        int begin = 0, end = 0;  ///< range in order_
        int left = -1;           ///< right child is left + 1; -1 in a leaf
    };
    void build(const TriangleMesh& mesh, const Points& centres, int node, int begin, int end);

    std::vector<Node> nodes_;
    std::vector<int> order_;
};

/// Barycentric weights of the point of a triangle that is nearest to `query`.
/// @cite ericson_collision, section 5.1.5.
Vec3 closest_barycentric(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& query);

}  // namespace myoface
