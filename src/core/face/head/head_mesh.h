// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "myoface/base/progress.h"
#include "myoface/mesh/triangle_mesh.h"

#include "head_field.h"

namespace myoface {

/// What a vertex of the generic head belongs to.
enum class HeadPart : std::uint8_t { Skin, LidMargin, Mouth, Eye, Caruncle, Tooth, Gum };

/// The average head as a mesh: skin in one piece with its linings, then eyeballs, caruncles, teeth
/// and gums as pieces of their own. Mirror-symmetric to the last bit.
struct HeadMesh {
    TriangleMesh mesh;           ///< [mm]
    std::vector<HeadPart> part;  ///< per vertex
};

/// The average head's surface; made once.
const HeadField& average_head();

/// @param vertices wanted, met within about 15 %
HeadMesh average_head_mesh(int vertices, const Progress* progress);

}  // namespace myoface
