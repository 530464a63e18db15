// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "myoface/face/face_model.h"

namespace myoface {

/// Normals of the face without its small features, 3×N: the directions in which tissue lies over
/// bone. The reach of the smoothing is in millimetres, not in rings.
Points smoothed_face_normals(const TriangleMesh& mesh, const Adjacency& adjacency);

/// The quadric of the smoothed face at every node: tangential curvature by least squares over the
/// surroundings, limited to radii of 12 mm hollow and 25 mm round.
std::vector<SlidingSurface> sliding_surfaces(const TriangleMesh& mesh, const Adjacency& adjacency,
                                             const Points& smooth_normals);

}  // namespace myoface
