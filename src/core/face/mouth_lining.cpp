// SPDX-License-Identifier: Apache-2.0
#include "mouth_lining.h"

#include <cmath>
#include <numbers>

#include "head/head_mesh.h"

namespace myoface {

bool has_mouth_bag(const TriangleMesh& scan, const std::function<Vec3(const Vec3&)>& from_generic) {
    constexpr double kDeepest = 60.0;  // [mm] what lies further behind the lips is the head's back
    constexpr double kStart = 85.0;    // behind the lips' front
    const Vec3 start = from_generic({0.0, -52.0, kStart});
    int closed = 0;
    int rays = 0;
    for (const double up : {-20.0, 0.0, 20.0}) {
        const Vec3 way = from_generic({0.0, -52.0 + up, kStart - kDeepest}) - start;
        bool hit = false;
        for (int t = 0; t < scan.triangle_count() && !hit; ++t) {
            const Vec3 a = scan.corner(t, 0);
            const Vec3 side1 = scan.corner(t, 1) - a;
            const Vec3 side2 = scan.corner(t, 2) - a;
            const Vec3 across = way.cross(side2);
            const double volume = side1.dot(across);
            if (volume == 0.0) {
                continue;
            }
            const Vec3 off = start - a;
            const double u = off.dot(across) / volume;
            const Vec3 turned = off.cross(side1);
            const double v = way.dot(turned) / volume;
            const double share = side2.dot(turned) / volume;
            hit = u >= 0.0 && v >= 0.0 && u + v <= 1.0 && share > 0.0 && share < 1.0;
        }
        closed += hit ? 1 : 0;
        ++rays;
    }
    return 2 * closed > rays;
}

MouthLining mouth_lining(const std::function<Vec3(const Vec3&)>& from_generic) {
    // On the average head [mm]: half-axes of the opening, which stays behind the lips, and depth.
    constexpr double kHalfWidth = 24.0;
    constexpr double kHalfHeight = 10.0;
    constexpr double kWidens = 0.5;  // behind the lips, around the rows of teeth
    constexpr double kBehindLips = 6.0;
    constexpr double kDeep = 48.0;
    constexpr int kAround = 32;
    constexpr int kRings = 10;
    const HeadField& head = average_head();
    MouthLining lining;
    lining.mesh.vertices.resize(3, kAround * kRings + 1);
    lining.with_jaw.resize(kAround * kRings + 1);
    lining.depth.resize(kAround * kRings + 1);
    const auto put = [&](int v, double x, double high, double share) {
        const double at = std::min(std::abs(x), HeadField::kMouthCorner);
        const double line = head.lip_line(at);
        const double front = head.front_point(at, line).z() - kBehindLips;
        lining.mesh.vertices.col(v) = from_generic({x, line + high, front - kDeep * share});
        lining.with_jaw[v] = 0.5 - 0.5 * std::tanh(high / 2.5);
        lining.depth[v] = share;
    };
    for (int ring = 0; ring < kRings; ++ring) {
        const double turn = 0.5 * std::numbers::pi * ring / kRings;
        const double wide = std::cos(turn) * (1.0 + kWidens * std::sin(2.0 * turn));
        for (int k = 0; k < kAround; ++k) {
            const double around = 2.0 * std::numbers::pi * k / kAround;
            put(ring * kAround + k, kHalfWidth * wide * std::cos(around),
                kHalfHeight * wide * std::sin(around), std::sin(turn));
        }
    }
    const int back = kAround * kRings;
    put(back, 0.0, 0.0, 1.0);
    std::vector<Eigen::Vector3i> triangles;
    for (int ring = 0; ring < kRings; ++ring) {
        for (int k = 0; k < kAround; ++k) {
            const int a = ring * kAround + k;
            const int b = ring * kAround + (k + 1) % kAround;
            const bool last = ring + 1 == kRings;
            triangles.emplace_back(a, b, last ? back : b + kAround);
            if (!last) {
                triangles.emplace_back(a, b + kAround, a + kAround);
            }
        }
    }
    lining.mesh.triangles.resize(3, static_cast<Eigen::Index>(triangles.size()));
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        lining.mesh.triangles.col(static_cast<Eigen::Index>(t)) = triangles[t];
    }
    return lining;
}

}  // namespace myoface
