// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "myoface/face/face_model.h"

namespace myoface {

/// The grabbed point: skin nodes and weights that sum to 1.
struct Grip {
    std::vector<int> nodes;
    std::vector<double> weights;
};
Grip grip_at(const FaceModel& face, const SurfacePoint& where);
Vec3 grip_position(const Grip& grip, const Points& positions);

/// A stress spread over the skin: nodes and weights that sum to 1.
struct StressKernel {
    std::vector<int> nodes;
    std::vector<double> weights;
    std::vector<double> profile;  ///< 1 at the grip … 0 at the rim, without areas
    double radius = 0.0;          ///< [mm] along equal labels
};

/// Takes nodes that may not be gripped out of a kernel, as far as they may not; what is left still
/// sums to 1. @param yielding per skin node 1 … 0
void spare(StressKernel& kernel, const Eigen::VectorXd& yielding);

/// How much a brush touches each skin node: 1 in the inner half of its radius, 0 at its rim.
/// @param radius along the surface [mm]
Eigen::VectorXd brushed(const FaceModel& face, const SurfacePoint& where, double radius);

/// The same place on the other side of the face, found on the average head, where it is exact.
SurfacePoint mirrored_place(const FaceModel& face, const SurfacePoint& where);

/// Grip radius that suits a region and the depth to the bone [mm].
double kernel_radius(const FaceModel& face, const Grip& grip);

/// w_j = (1 − g²/R²)² A_j, normalised; g is the distance along the surface in which a way over
/// skin with the grip's label counts its length and over another's counts more, so that a stress
/// goes first along the same muscle. How much more follows how much of the muscles under the grip
/// lies under a node: the answer does not depend on the triangles. Nodes that do not move take no
/// part.
/// @param other_label how much longer a way over another label counts
/// @param elongation how many times further it goes along the fibres of the muscles under the grip
///        (around a sphincter) than across them. @see FibreWay
StressKernel stress_kernel(const FaceModel& face, const Points& skin, const Grip& grip,
                           double radius, double other_label = 1.8, double elongation = 1.0);

}  // namespace myoface
