// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "myoface/scene/scene.h"

namespace myoface {

/// A line through points, in one colour.
void add_line(LineLayer& lines, const std::vector<Vec3>& points, const Eigen::Vector3f& colour);
/// An arrow from a place, flat to somebody who looks along `view`; none shorter than half a
/// millimetre.
void add_arrow(LineLayer& lines, const Vec3& from, const Vec3& way, const Vec3& view,
               const Eigen::Vector3f& colour);

}  // namespace myoface
