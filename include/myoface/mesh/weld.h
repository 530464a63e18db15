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
    int degenerate = 0;            ///< triangles left out for want of area
    int duplicates = 0;            ///< triangles left out since an earlier one has their corners
};

/// Joins vertices that lie at exactly the same place (as UV seams leave them) and drops triangles
/// that have two equal corners, no area, or the corners of an earlier triangle. Welded vertices and
/// triangles keep the input's order.
WeldedMesh weld(const TriangleMesh& mesh);

}  // namespace myoface
