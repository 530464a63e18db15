// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include "myoface/base/points.h"

// Signed fields of simple bodies [mm], negative inside, and how they are joined.
namespace myoface {

/// Smooth union: polynomial, k is the width of the blend [mm].
inline double smooth_min(double a, double b, double k) {
    const double h = std::max(k - std::abs(a - b), 0.0) / k;
    return std::min(a, b) - 0.25 * k * h * h;
}
inline double smooth_max(double a, double b, double k) {
    return -smooth_min(-a, -b, k);
}
inline double subtract(double d, double hole, double k) {
    return smooth_max(d, -hole, k);
}

/// First-order distance to an ellipsoid, given its local coordinates.
inline double ellipsoid_local(const Vec3& local, const Vec3& radii) {
    const double k0 = local.cwiseQuotient(radii).norm();
    const double k1 = local.cwiseQuotient(radii.cwiseProduct(radii)).norm();
    return k1 > 1e-12 ? k0 * (k0 - 1.0) / k1 : -radii.minCoeff();
}
inline double ellipsoid(const Vec3& p, const Vec3& centre, const Vec3& radii) {
    return ellipsoid_local(p - centre, radii);
}

inline double capsule(const Vec3& p, const Vec3& a, const Vec3& b, double radius_a,
                      double radius_b) {
    const Vec3 ab = b - a;
    const double t = std::clamp((p - a).dot(ab) / ab.squaredNorm(), 0.0, 1.0);
    return (p - a - t * ab).norm() - (radius_a + t * (radius_b - radius_a));
}

/// A box with half edges `half`, its edges rounded by `radius` within it.
inline double rounded_box(const Vec3& local, const Vec3& half, double radius) {
    const Vec3 q = local.cwiseAbs() - half + Vec3::Constant(radius);
    return q.cwiseMax(0.0).norm() + std::min(q.maxCoeff(), 0.0) - radius;
}

}  // namespace myoface
