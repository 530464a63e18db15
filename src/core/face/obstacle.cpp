// SPDX-License-Identifier: Apache-2.0
#include "myoface/face/obstacle.h"

#include <algorithm>

#include "myoface/base/parallel.h"
#include "myoface/face/face_model.h"

namespace myoface {
namespace {

constexpr int kObstacleGrain = 64;

/// The triangles of the bone that belong to one jaw.
TriangleMesh part_of_bone(const FaceModel& face, bool lower) {
    const auto is_lower = [&](int v) {
        const BonePart part = face.bone_part[static_cast<std::size_t>(v)];
        return part == BonePart::Mandible || part == BonePart::LowerTeeth;
    };
    std::vector<int> vertices, triangles;
    std::vector<int> index(static_cast<std::size_t>(face.bone.vertex_count()), -1);
    for (int v = 0; v < face.bone.vertex_count(); ++v) {
        if (is_lower(v) == lower) {
            index[static_cast<std::size_t>(v)] = static_cast<int>(vertices.size());
            vertices.push_back(v);
        }
    }
    for (int t = 0; t < face.bone.triangle_count(); ++t) {
        if (is_lower(face.bone.triangles(0, t)) == lower) {
            triangles.push_back(t);
        }
    }
    TriangleMesh part;
    part.vertices = face.bone.vertices(Eigen::all, vertices);
    part.triangles = face.bone.triangles(Eigen::all, triangles);
    part.triangles =
        part.triangles.unaryExpr([&](int v) { return index[static_cast<std::size_t>(v)]; });
    return part;
}

}  // namespace

DistanceField::Sample distance_to(const Obstacle& obstacle, const Vec3& p) {
    if (obstacle.bone) {
        return obstacle.bone->at(p);
    }
    const Vec3 off = p - obstacle.centre;
    const double distance = off.norm();
    return {distance - obstacle.radius,
            distance > 0.0 ? Vec3(off / distance) : Vec3(Vec3::UnitZ())};
}

std::vector<Obstacle> obstacles_of(const FaceModel& face) {
    std::vector<Obstacle> obstacles(4);
    parallel_for(2, 1, [&](int begin, int end) {
        for (int k = begin; k < end; ++k) {
            obstacles[static_cast<std::size_t>(k)].bone =
                std::make_shared<DistanceField>(part_of_bone(face, k == 1));
        }
    });
    obstacles[1].with_jaw = true;
    for (int eye = 0; eye < 2; ++eye) {
        obstacles[static_cast<std::size_t>(2 + eye)].centre = face.eyes.col(eye);
        obstacles[static_cast<std::size_t>(2 + eye)].radius =
            generic_eye_radius() / face.to_generic.scale;
    }
    return obstacles;
}

Eigen::VectorXd obstacle_distances(const FaceModel& face) {
    Eigen::VectorXd distances(face.node_count());
    parallel_for(face.node_count(), kObstacleGrain, [&](int begin, int end) {
        for (int i = begin; i < end; ++i) {
            distances[i] = 1e3;
            for (const Obstacle& obstacle : face.obstacles) {
                if (face.tissue[static_cast<std::size_t>(i)].fixed) {
                    break;
                }
                const Vec3 p = face.skin.mesh.vertices.col(i);
                distances[i] =
                    std::min(distances[i], obstacle.bone ? obstacle.bone->exact(p)
                                                         : distance_to(obstacle, p).distance);
            }
        }
    });
    return distances;
}

std::vector<Eigen::Isometry3d> obstacle_poses(const FaceModel& face, const JawPose& jaw) {
    std::vector<Eigen::Isometry3d> poses(face.obstacles.size(), Eigen::Isometry3d::Identity());
    for (std::size_t k = 0; k < poses.size() && !jaw.rests(); ++k) {
        if (face.obstacles[k].with_jaw) {
            const Vec3 origin = opened(face.jaw, jaw, Vec3::Zero());
            for (int axis = 0; axis < 3; ++axis) {
                poses[k].linear().col(axis) = opened(face.jaw, jaw, Vec3::Unit(axis)) - origin;
            }
            poses[k].translation() = origin;
        }
    }
    return poses;
}

}  // namespace myoface
