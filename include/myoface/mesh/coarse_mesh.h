// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "myoface/mesh/triangle_mesh.h"

namespace myoface {

/// A mesh of fewer vertices over the same surface, and how the finer one lies between them.
struct CoarseMesh {
    TriangleMesh mesh;      ///< its vertices are some of the finer mesh's, in their order
    std::vector<int> fine;  ///< per coarse vertex: its number in the finer mesh
    /// Per fine vertex: the coarse vertices it lies between. The first one alone, with -1 behind,
    /// where the vertex is one of them or no coarse triangle is near.
    Eigen::Matrix<int, 3, Eigen::Dynamic> between;
    Eigen::Matrix<float, 3, Eigen::Dynamic> shares;  ///< of each of them, sum 1
};

/// Spreads vertices over a mesh so that every other one has one of them within its own spacing,
/// measured along the edges, and joins those whose surroundings touch (the dual of the Voronoi
/// cells on the surface). Borders are followed by vertices of the border; sheets that are not
/// connected, as lips, stay apart however near they lie.
/// @param spacing per vertex, > 0 [mm]
/// @param kept vertices that the coarse mesh must have
/// @cite eldar_1997 @cite peyre_2006
CoarseMesh coarsen(const TriangleMesh& mesh, const Eigen::VectorXf& spacing,
                   const std::vector<int>& kept = {});

}  // namespace myoface
