// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <utility>
#include <vector>

#include "myoface/mesh/triangle_mesh.h"

namespace myoface::test {

/// Smallest angle of a triangle [deg].
double smallest_angle(const TriangleMesh& mesh, int triangle);

/// Pairs of triangles that run through each other and share no vertex, tried by segment against
/// triangle; touching within `tolerance` [mm] does not count.
std::vector<std::pair<int, int>> crossing_triangles(const TriangleMesh& mesh,
                                                    double tolerance = 1e-7);

}  // namespace myoface::test
