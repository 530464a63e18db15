// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include <Eigen/Geometry>

#include "myoface/mesh/distance_field.h"

namespace myoface {

struct FaceModel;
struct JawPose;

/// A rigid thing that skin cannot enter: a bone with its teeth, or an eyeball.
struct Obstacle {
    std::shared_ptr<const DistanceField> bone;  ///< null: a sphere
    Vec3 centre = Vec3::Zero();                 ///< of the sphere [mm]
    double radius = 0.0;
    bool with_jaw = false;  ///< goes with the mandible
};

/// Signed distance of a place from an obstacle where it rests, with its gradient.
DistanceField::Sample distance_to(const Obstacle& obstacle, const Vec3& p);

/// Skull and mandible with their teeth, and both eyeballs.
std::vector<Obstacle> obstacles_of(const FaceModel& face);

/// Distance of every skin node from what is nearest among the face's obstacles [mm].
Eigen::VectorXd obstacle_distances(const FaceModel& face);

/// Where obstacles stand in a pose of the jaw: one motion each.
std::vector<Eigen::Isometry3d> obstacle_poses(const FaceModel& face, const JawPose& jaw);

}  // namespace myoface
