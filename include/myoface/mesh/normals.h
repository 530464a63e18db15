// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "myoface/mesh/adjacency.h"
#include "myoface/mesh/triangle_mesh.h"

namespace myoface {

/// Area-weighted unit normal per vertex, 3×N. A vertex without area gets +z.
Points vertex_normals(const TriangleMesh& mesh, const Adjacency& adjacency);

/// A third of the area of the triangles around each vertex [mm²], N.
Eigen::VectorXd vertex_areas(const TriangleMesh& mesh);

/// Volume enclosed by a closed mesh [mm³]; for an open mesh, of the cone from the origin.
double signed_volume(const TriangleMesh& mesh);

/// Values after `passes` of x ← x + ½ (mean of neighbours − x). Isolated vertices stay.
Points smoothed(const Points& values, const Adjacency& adjacency, int passes);

}  // namespace myoface
