// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "myoface/mesh/triangle_mesh.h"

namespace myoface {

/// Points spread evenly over the area of a mesh, with the normals of their triangles.
struct SurfaceSamples {
    Points points, normals;  ///< 3×N
    double area = 0.0;       ///< that each stands for [unit of the points, squared]
};
SurfaceSamples sample_surface(const TriangleMesh& mesh, int count);

/// How far each sample stands above the samples around it: mean over those within `reach` of its
/// height over them along the mean normal there [unit of the points]; below 0 in creases.
Eigen::VectorXd relief(const SurfaceSamples& samples, double reach);

/// Finds a sample near a place fast: for every cell of a grid the sample closest to it, known as
/// far as `reach` cells away from the samples.
class NearestTable {
public:
    NearestTable(const Points& points, double cell, int reach);

    /// Number of a sample near p, about the nearest, or -1 where there is none within reach.
    int near(const Vec3& p) const {
        const Eigen::Array3d at = (p - low_).array() / cell_;
        if ((at < 0.0).any() || (at >= size_.cast<double>()).any()) {
            return -1;
        }
        return cells_[index(at.cast<int>())];
    }

private:
    std::size_t index(const Eigen::Array3i& at) const {
        return static_cast<std::size_t>(at.x()) +
               static_cast<std::size_t>(size_.x()) *
                   (static_cast<std::size_t>(at.y()) +
                    static_cast<std::size_t>(size_.y()) * static_cast<std::size_t>(at.z()));
    }

    Vec3 low_ = Vec3::Zero();
    double cell_ = 1.0;
    Eigen::Array3i size_ = Eigen::Array3i::Zero();
    std::vector<int> cells_;
};

}  // namespace myoface
