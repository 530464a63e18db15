// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "myoface/mesh/triangle_mesh.h"

namespace myoface::test {

struct NoFace {
    std::string name;
    TriangleMesh mesh;
};

/// Things a person may open by mistake, none of them a face: bodies, blobs, tools, parts of heads
/// without the face, noise.
std::vector<NoFace> no_faces();

}  // namespace myoface::test
