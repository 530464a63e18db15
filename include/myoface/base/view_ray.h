// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "myoface/base/points.h"

namespace myoface {

/// The line of sight through one pixel: origin [mm] and unit direction, pointing away from the eye.
struct ViewRay {
    Vec3 origin = Vec3::Zero();
    Vec3 direction = -Vec3::UnitZ();
};

/// Distance of a point to the ray's line [mm].
inline double distance_to_ray(const ViewRay& ray, const Vec3& point) {
    const Vec3 offset = point - ray.origin;
    return (offset - offset.dot(ray.direction) * ray.direction).norm();
}

/// Two unit vectors that complete the ray's direction to an orthonormal frame.
/// The first is as horizontal as the direction allows.
inline Eigen::Matrix<double, 3, 2> view_plane(const Vec3& direction) {
    const Vec3 v = direction.normalized();
    Vec3 right = v.cross(Vec3::UnitY());
    if (right.norm() < 1e-6) {
        right = Vec3::UnitX();
    }
    right.normalize();
    Eigen::Matrix<double, 3, 2> plane;
    plane.col(0) = right;
    plane.col(1) = right.cross(v);
    return plane;
}

/// front, left, right, three-quarter-left, three-quarter-right, below, above, back: the side named
/// is the patient's that faces the viewer.
/// @return viewer's axes -> ours: columns right, up, towards the viewer
/// @throws InvalidInput for another name
Eigen::Quaterniond standard_view(const std::string& name);

}  // namespace myoface
