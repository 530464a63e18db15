// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <utility>
#include <vector>

#include "myoface/mesh/triangle_mesh.h"

namespace myoface {

/// Where a plane cuts a mesh: one segment per triangle that it crosses, in the triangles' order.
/// @param normal of the plane, any length but 0
std::vector<std::pair<Vec3, Vec3>> cross_section(const TriangleMesh& mesh, const Vec3& through,
                                                 const Vec3& normal);

}  // namespace myoface
