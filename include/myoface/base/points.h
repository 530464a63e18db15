// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace myoface {

using Vec2 = Eigen::Vector2d;
using Vec3 = Eigen::Vector3d;
using Mat3 = Eigen::Matrix3d;

/// 3×N, a column per point [mm unless said otherwise].
using Points = Eigen::Matrix3Xd;

/// 3×T, a column of vertex numbers per triangle, counter-clockwise seen from outside.
using Triangles = Eigen::Matrix<int, 3, Eigen::Dynamic>;

}  // namespace myoface
