// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <vector>

#include "myoface/mesh/bvh.h"
#include "myoface/mesh/triangle_mesh.h"

namespace myoface {

/// Signed distance to a closed surface, negative inside: quadratic B-splines over exact values on a
/// lattice. Its gradient is the gradient of what it says and has no jumps: where a slope jumps,
/// skin that is pressed against bone finds no rest. A surface of radius R seems h²/4R further out
/// for it (h: cell). A value of the lattice is found when somebody first asks near it; it does not
/// depend on when or by whom, and any number of threads may ask.
/// @cite ericson_collision
class DistanceField {
public:
    /// @param surface closed, faces outwards [mm]
    /// @param cell edge of a lattice cell [mm]
    explicit DistanceField(TriangleMesh surface, double cell = 1.5);

    struct Sample {
        double distance = 0.0;      ///< [mm]
        Vec3 slope = Vec3::Zero();  ///< its gradient
    };
    /// Beyond the box around the surface the distance is a lower bound, without slope.
    Sample at(const Vec3& p) const;

    /// The distance itself, without the lattice.
    double exact(const Vec3& p) const;

    const TriangleMesh& surface() const { return surface_; }

private:
    double exact(const Vec3& p, double within) const;
    void find_around(const Eigen::Vector3i& nearest) const;
    std::size_t index(const Eigen::Vector3i& lattice) const;

    TriangleMesh surface_;
    Bvh bvh_;
    Points normals_;  ///< per vertex
    double cell_;
    Eigen::AlignedBox3d box_;
    Eigen::Vector3i points_;                          ///< of the lattice along each axis
    mutable std::vector<std::atomic<float>> values_;  ///< [mm]; not a number: not yet found
};

}  // namespace myoface
