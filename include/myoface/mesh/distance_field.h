// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <atomic>
#include <memory>
#include <vector>

#include "myoface/mesh/bvh.h"
#include "myoface/mesh/triangle_mesh.h"

namespace myoface {

/// Signed distance to a closed surface, negative inside: quadratic B-splines over exact values on a
/// lattice. Its gradient is the gradient of what it says and has no jumps: where a slope jumps,
/// skin that is pressed against bone finds no rest. A surface of radius R seems h²/4R further out
/// for it (h: cell). Blocks of the lattice are filled when somebody first asks there; what they
/// hold does not depend on when or by whom, and any number of threads may ask.
/// @cite ericson_collision
class DistanceField {
public:
    /// @param surface closed, faces outwards [mm]
    /// @param cell edge of a lattice cell [mm]
    explicit DistanceField(TriangleMesh surface, double cell = 1.5);
    ~DistanceField();
    DistanceField(const DistanceField&) = delete;
    DistanceField& operator=(const DistanceField&) = delete;

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
    static constexpr int kSide = 4;         ///< lattice points of a block along an edge
    static constexpr int kRow = kSide + 2;  ///< with the neighbours beyond
    using Block = std::array<float, kRow * kRow * kRow>;

    double exact(const Vec3& p, double within) const;
    const Block& block(const Eigen::Vector3i& which) const;

    TriangleMesh surface_;
    Bvh bvh_;
    Points normals_;  ///< per vertex
    double cell_;
    Eigen::AlignedBox3d box_;
    Eigen::Vector3i blocks_;
    mutable std::vector<std::atomic<const Block*>> filled_;
};

}  // namespace myoface
