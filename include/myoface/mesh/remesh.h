// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

#include "myoface/mesh/triangle_mesh.h"

namespace myoface {

struct RemeshOptions {
    /// Wanted edge length at a place [mm].
    std::function<double(const Vec3&)> edge_length;
    /// Puts a point back on the true surface; `on_border` points must stay on the border.
    std::function<Vec3(const Vec3&, bool on_border)> project;
    int rounds = 5;
};

/// Even triangles of the wanted size by edge splits, collapses, flips and tangential smoothing.
/// Border vertices stay on the border. The surface stays manifold.
/// @cite botsch_kobbelt_2004
TriangleMesh remesh(const TriangleMesh& mesh, const RemeshOptions& options);

}  // namespace myoface
