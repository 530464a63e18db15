// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "myoface/base/view_ray.h"

namespace myoface {

/// Where a point stands in the plane across a ray.
inline Eigen::Vector2d in_plane(const ViewRay& ray, const Vec3& point) {
    return view_plane(ray.direction).transpose() * point;
}

}  // namespace myoface
