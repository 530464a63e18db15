// SPDX-License-Identifier: Apache-2.0
#include "eyeballs.h"

#include <cmath>

#include "myoface/base/smooth_step.h"
#include "myoface/mesh/bvh.h"

#include "head/head_colour.h"
#include "head/head_parts.h"

namespace myoface {
namespace {

/// The triangles beside the line through an eye to the front. @param local in the eye's own axes
TriangleMesh in_front_of(const TriangleMesh& scan, const Points& local, double radius) {
    const double beside = 0.6 * radius;
    TriangleMesh near;
    near.vertices = local;
    std::vector<int> kept;
    for (int t = 0; t < scan.triangle_count(); ++t) {
        Eigen::AlignedBox3d box;
        for (const int v : scan.triangles.col(t)) {
            box.extend(Vec3(local.col(v)));
        }
        if (box.min().x() < beside && box.max().x() > -beside && box.min().y() < beside &&
            box.max().y() > -beside && box.max().z() > -2.0 * radius) {
            kept.push_back(t);
        }
    }
    near.triangles = scan.triangles(Eigen::all, kept);
    return near;
}

bool is_empty(const TriangleMesh& near, double radius) {
    constexpr double kDeep = 0.35;  // of the radius behind the eye's front: no eye ends there
    constexpr int kFewest = 5;      // of 25 rays: lids hide the others
    const Bvh bvh(near);
    int through = 0;
    for (const double x : {-0.3, -0.15, 0.0, 0.15, 0.3}) {
        for (const double y : {-0.4, -0.2, 0.0, 0.2, 0.4}) {
            const Vec3 start(x * radius, y * radius, 3.0 * radius);
            const auto hit = bvh.first_hit(near, {start, -Vec3::UnitZ()});
            through += !hit || hit->distance > (2.0 + kDeep) * radius;
        }
    }
    return through >= kFewest;
}

/// How far back an eyeball must stand so that hardly any skin in front lies in it [mm].
double room_for_lids(const Points& local, double radius) {
    constexpr double kStep = 0.25;     // [mm]
    constexpr double kFurthest = 4.0;  // [mm]
    constexpr double kMostInside = 0.02;
    for (double back = 0.0; back < kFurthest; back += kStep) {
        int inside = 0;
        int front = 0;
        for (const Vec3 p : local.colwise()) {
            if (p.z() > 0.3 * radius && p.head<2>().norm() < radius && p.norm() < 1.6 * radius) {
                ++front;
                inside += (p + back * Vec3::UnitZ()).norm() < radius;
            }
        }
        if (inside <= kMostInside * front) {
            return back;
        }
    }
    return kFurthest;
}

/// What lids and lashes leave of the light.
float light_between_lids(const Vec3& way) {
    const double above = smooth_step(0.1, 0.7, way.y());
    const double below = smooth_step(0.3, 0.8, -way.y());
    const double aside = smooth_step(0.4, 0.9, std::abs(way.x()));
    return static_cast<float>((1.0 - 0.45 * above) * (1.0 - 0.2 * below) * (1.0 - 0.3 * aside));
}

}  // namespace

Eyeballs eyeballs_for(const FaceModel& face) {
    constexpr int kAround = 64;
    constexpr double kUnderLids = 0.99;  // of the radius that lids lie on
    const double own = generic_eye_radius();
    const double radius = own / face.to_generic.scale;
    const TriangleMesh& scan = face.scan->mesh;
    MeshBuilder average;
    add_eyeball(average, Vec3::Zero(), kAround);
    const TriangleMesh ball = average.mesh();
    Eyeballs result;
    for (const Vec3 eye : face.eyes.colwise()) {
        const Points local = face.axes.transpose() * (scan.vertices.colwise() - eye);
        if (!is_empty(in_front_of(scan, local, radius), radius)) {
            continue;
        }
        const Vec3 centre = eye - room_for_lids(local, kUnderLids * radius) * face.axes.col(2);
        const Eigen::Index before = result.mesh.vertices.cols();
        const Eigen::Index n = ball.vertices.cols();
        result.mesh.vertices.conservativeResize(3, before + n);
        result.colours.conservativeResize(3, before + n);
        for (Eigen::Index v = 0; v < n; ++v) {
            const Vec3 way = ball.vertices.col(v).normalized();
            const Vec3 colour =
                head_colour(HeadPart::Eye, generic_eye_centre() + own * way, HeadLook{}, true);
            result.mesh.vertices.col(before + v) = centre + kUnderLids * radius * (face.axes * way);
            result.colours.col(before + v) = light_between_lids(way) * colour.cast<float>();
        }
        const Eigen::Index triangles = result.mesh.triangles.cols();
        result.mesh.triangles.conservativeResize(3, triangles + ball.triangles.cols());
        result.mesh.triangles.rightCols(ball.triangles.cols()) =
            ball.triangles.array() + static_cast<int>(before);
    }
    return result;
}

}  // namespace myoface
