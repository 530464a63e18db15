// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <utility>
#include <vector>

#include "myoface/face/simulated_skin.h"
#include "myoface/face/smooth_warp.h"
#include "myoface/mesh/weld.h"

namespace myoface {

/// The skin to simulate: every vertex of the part, or fewer where it is finer than the simulation
/// needs. Normals are not set yet.
/// @param lips pairs of the part's vertices that touch, upper and lower; given back as nodes. Of a
///        coarser skin some of them, each of which is a node.
/// @param finest at most so many vertices are simulated as they are
SimulatedSkin simulated_skin(const WeldedMesh& part, const Similarity& to_generic, int finest,
                             std::vector<std::pair<int, int>>& lips);

/// Sets `surroundings` of a coarser skin. @pre mesh and normals are set
void prepare_following(SimulatedSkin& skin, const Adjacency& adjacency);

}  // namespace myoface
