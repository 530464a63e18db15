// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "myoface/face/face_model.h"

namespace myoface {

/// The face without its small features: tissue lies over bone in the direction of `normals`, 3×N.
struct SmoothFace {
    Points vertices;  ///< lightly smoothed: lips and nostrils gone, chin and cheeks kept
    Points normals;   ///< unit
};
SmoothFace smooth_face(const TriangleMesh& mesh, const Adjacency& adjacency);

/// The quadric of the smoothed face at every node: tangential curvature by least squares over the
/// surroundings, limited to radii of 12 mm hollow and 25 mm round.
std::vector<SlidingSurface> sliding_surfaces(const TriangleMesh& mesh, const Adjacency& adjacency,
                                             const Points& smooth_normals);

}  // namespace myoface
