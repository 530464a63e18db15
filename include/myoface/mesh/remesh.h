// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <vector>

#include "myoface/mesh/triangle_mesh.h"

namespace myoface {

/// What a vertex may do while the mesh is made anew: lie freely on the surface, slide along a line
/// (1, 2, …: numbers of the caller's), or stay where it is.
constexpr int kFreeVertex = 0;
constexpr int kPinnedVertex = -1;

struct RemeshOptions {
    /// Wanted edge length at a place [mm].
    std::function<double(const Vec3&)> edge_length;
    /// Puts a point back on the true surface, or on one of its lines. Never asked of pinned ones.
    std::function<Vec3(const Vec3&, int line)> project;
    /// Per vertex; empty: border vertices are on line 1, all others free. Lines run along borders.
    std::vector<int> lines;
    int rounds = 5;
};

struct RemeshedSurface {
    TriangleMesh mesh;
    std::vector<int> lines;  ///< per vertex
};

/// Even triangles of the wanted size by edge splits, collapses, flips and tangential smoothing.
/// Border vertices stay on their border line. The surface stays manifold.
/// @cite botsch_kobbelt_2004
RemeshedSurface remesh(const TriangleMesh& mesh, const RemeshOptions& options);

}  // namespace myoface
