// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

#include <Eigen/Geometry>

#include "myoface/mesh/triangle_mesh.h"

namespace myoface {

/// Negative inside, positive outside, roughly a distance [mm].
using ScalarField = std::function<double(const Vec3&)>;

/// Triangles of the zero set inside a box, by marching tetrahedra on a cubic grid whose first
/// planes lie on the box's lower faces. Watertight but for the box's faces, where the surface ends.
/// @param cell edge of a grid cell [mm]
/// @cite doi_koide_1991
TriangleMesh isosurface(const ScalarField& field, const Eigen::AlignedBox3d& box, double cell);

}  // namespace myoface
