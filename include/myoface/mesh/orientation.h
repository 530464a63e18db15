// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "myoface/mesh/adjacency.h"

namespace myoface {

/// Which triangles of a mesh must be turned over for its surface to look outwards everywhere.
struct Orientation {
    std::vector<bool> turn;  ///< per triangle
    int disagreeing = 0;     ///< triangles wound against most of their sheet
    bool inward = false;     ///< the largest sheet looked inwards as a whole
};

/// Makes neighbours across every edge of two triangles agree, the larger area deciding, then turns
/// sheets over that look inwards: all of them by the volume they enclose about their own middle if
/// the largest does so, else none (a small part may be a cavity).
Orientation outward_orientation(const TriangleMesh& mesh, const Adjacency& adjacency);

}  // namespace myoface
