// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "myoface/mesh/triangle_mesh.h"

namespace myoface {

/// What the edges of a mesh tell about its surface, found in one pass over them, and which
/// triangles must be turned over for it to look outwards everywhere.
struct SurfaceCheck {
    std::vector<bool> turn;       ///< per triangle; empty where none need be
    int disagreeing = 0;          ///< triangles wound against most of their sheet
    bool inward = false;          ///< the largest sheet looked inwards as a whole
    int non_manifold_edges = 0;   ///< shared by more than two triangles
    int border_loops = 0;         ///< closed runs of edges with one triangle
    double longest_border = 0.0;  ///< length of the longest [mm]
};

/// Makes neighbours across every edge of two triangles agree, the larger area deciding, then turns
/// sheets over that look inwards: all of them by the volume they enclose about their own middle if
/// the largest does so, else none (a small part may be a cavity). @pre no triangle has a corner
/// twice
SurfaceCheck check_surface(const TriangleMesh& mesh);

}  // namespace myoface
