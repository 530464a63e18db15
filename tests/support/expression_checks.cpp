// SPDX-License-Identifier: Apache-2.0
#include "expression_checks.h"

#include <algorithm>
#include <cmath>

#include "myoface/measure/landmarks_on_skin.h"
#include "myoface/mesh/bvh.h"

namespace myoface::test {
namespace {

/// Skin that is seen: no linings.
TriangleMesh seen_skin(const FaceModel& face, const Points& nodes) {
    const Triangles& all = face.skin.mesh.triangles;
    TriangleMesh mesh{nodes.leftCols(face.node_count()), Triangles(3, all.cols())};
    const auto seen = [&](int node) {
        return face.tissue[static_cast<std::size_t>(node)].tissue == Tissue::Skin;
    };
    Eigen::Index count = 0;
    for (Eigen::Index t = 0; t < all.cols(); ++t) {
        if (seen(all(0, t)) && seen(all(1, t)) && seen(all(2, t))) {
            mesh.triangles.col(count++) = all.col(t);
        }
    }
    mesh.triangles.conservativeResize(3, count);
    return mesh;
}

/// The longest run of rays that meet no skin before the middle of the eyeball [mm].
double open_run(const FaceModel& face, const TriangleMesh& skin, const Bvh& bvh, Side side) {
    constexpr double kStep = 0.1;
    const Vec3 eye = face.eyes.col(side == Side::Left ? 0 : 1);
    const Vec3 left = face.axes.col(0);
    const Vec3 up = face.axes.col(1);
    const Vec3 front = face.axes.col(2);
    const double size = 1.0 / face.to_generic.scale;
    const double far = 60.0 * size;
    double longest = 0.0;
    for (double across = -9.0 * size; across <= 9.0 * size; across += 1.5 * size) {
        double run = 0.0;
        for (double height = -11.0 * size; height <= 11.0 * size; height += kStep) {
            const Vec3 from = eye + across * left + height * up + far * front;
            const auto hit = bvh.first_hit(skin, {from, -front});
            run = hit && hit->distance < far ? 0.0 : run + kStep;
            longest = std::max(longest, run);
        }
    }
    return longest;
}

}  // namespace

CornerTravel corner_travel(const Simulator& simulator, Side side) {
    const LandmarksOnSkin places(simulator.shared_face());
    const FaceModel& face = simulator.face();
    const char* name = side == Side::Left ? "ch_l" : "ch_r";
    const Vec3 moved =
        face.axes.transpose() * (places.at(simulator.state().positions).at(name).position -
                                 places.at(face.skin.mesh.vertices).at(name).position);
    return {moved.norm(), moved.y(), -moved.z(), side == Side::Left ? moved.x() : -moved.x()};
}

std::optional<double> lid_gap(const FaceModel& face, const Points& nodes, Side side) {
    constexpr double kOpen = 3.0;  // an eye that is open at rest [mm]
    const TriangleMesh rest = seen_skin(face, face.skin.mesh.vertices);
    const double at_rest = open_run(face, rest, Bvh(rest), side);
    if (at_rest < kOpen || at_rest > 20.0) {
        return std::nullopt;
    }
    const TriangleMesh now = seen_skin(face, nodes);
    return open_run(face, now, Bvh(now), side);
}

double deepest_in_eye(const FaceModel& face, const Points& nodes) {
    double deepest = 0.0;
    for (const Obstacle& obstacle : face.obstacles) {
        for (int i = 0; !obstacle.bone && i < face.node_count(); ++i) {
            const TissueProperties& tissue = face.tissue[static_cast<std::size_t>(i)];
            const double rest = distance_to(obstacle, face.skin.mesh.vertices.col(i)).distance;
            if (tissue.tissue == Tissue::Skin && !tissue.fixed && rest > 0.0) {
                deepest = std::max(deepest, -distance_to(obstacle, nodes.col(i)).distance);
            }
        }
    }
    return deepest;
}

double deepest_in_bone(const FaceModel& face, const Points& nodes, const JawPose& jaw) {
    const std::vector<Eigen::Isometry3d> poses = obstacle_poses(face, jaw);
    double deepest = 0.0;
    for (std::size_t k = 0; k < face.obstacles.size(); ++k) {
        const Obstacle& obstacle = face.obstacles[k];
        const Eigen::Isometry3d back = poses[k].inverse();
        for (int i = 0; obstacle.bone && i < face.node_count(); ++i) {
            const TissueProperties& tissue = face.tissue[static_cast<std::size_t>(i)];
            if (tissue.tissue == Tissue::Skin && !tissue.fixed && face.obstacle_distance[i] > 0.5) {
                const Vec3 p = nodes.col(i);
                deepest = std::max(deepest, -distance_to(obstacle, back * p).distance);
            }
        }
    }
    return deepest;
}

LipState lips(const FaceModel& face, const Points& nodes) {
    const Vec3 up = face.axes.col(1);
    LipState state;
    for (const auto& [upper, lower] : face.lip_contacts) {
        const Vec3 before = face.skin.mesh.vertices.col(upper) - face.skin.mesh.vertices.col(lower);
        const Vec3 now = nodes.col(upper) - nodes.col(lower);
        state.crossed = std::max(state.crossed, std::min(up.dot(before), 0.0) - up.dot(now));
        if (std::abs(face.generic(0, upper)) < 8.0) {
            state.apart = std::max(state.apart, up.dot(now) - std::max(up.dot(before), 0.0));
        }
    }
    return state;
}

double share_on_other_side(const FaceModel& face, const Points& nodes, Side side) {
    constexpr double kMargin = 6.0;  // [mm]
    double all = 0.0;
    double other = 0.0;
    for (int i = 0; i < face.node_count(); ++i) {
        const double way = face.area[i] * (nodes.col(i) - face.skin.mesh.vertices.col(i)).norm();
        const double own = side == Side::Left ? face.generic(0, i) : -face.generic(0, i);
        all += way;
        other += own < -kMargin ? way : 0.0;
    }
    return all > 0.0 ? other / all : 0.0;
}

StepReport pose(Simulator& simulator, const std::vector<double>& rates) {
    simulator.set_contractions(rates);
    return simulator.settle();
}

}  // namespace myoface::test
