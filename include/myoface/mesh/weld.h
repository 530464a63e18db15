// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "myoface/mesh/triangle_mesh.h"

namespace myoface {

/// A mesh whose coincident vertices are one, and the way back.
struct WeldedMesh {
    TriangleMesh mesh;             ///< only vertices that a triangle uses, no degenerate triangles
    std::vector<int> of_vertex;    ///< input vertex -> welded vertex, -1 where no triangle uses it
    std::vector<int> of_triangle;  ///< welded triangle -> input triangle
};

/// Joins vertices that lie at exactly the same place (as UV seams leave them) and drops triangles
/// that have two equal corners or no area. Welded vertices keep the input's order.
WeldedMesh weld(const TriangleMesh& mesh);

}  // namespace myoface
