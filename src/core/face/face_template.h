// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "myoface/base/points.h"

namespace myoface {

/// The front of the average head as points, ordered so that any number of the first ones covers it
/// evenly. Frame and unit of the generic face.
struct FaceTemplate {
    Points points, normals;  ///< 3×N
    /// N each: relief(), see there, over kFineReach and kCoarseReach [mm].
    Eigen::VectorXd fine_relief, coarse_relief;
    Eigen::VectorXd weights;  ///< N: less where faces differ (open or closed eyes) and at the rim
    Vec3 tip = Vec3::Zero();  ///< of the nose
    Vec3 tip_normal = Vec3::UnitZ();  ///< mean normal around it
    double tip_height = 0.0;          ///< protrusion(), see there
    Vec3 centre = Vec3::Zero();       ///< mean of the points
};

/// Built once.
const FaceTemplate& face_template();

/// How far a surface stands out at a point: mean over the points around it, within kNoseReach, of
/// the height of the point over them along its normal, by the reach.
inline constexpr double kNoseReach = 30.0;    // [mm]
inline constexpr double kFineReach = 5.0;     // [mm] of creases
inline constexpr double kCoarseReach = 11.0;  // [mm] of what they lie between
inline constexpr double kNormalReach = 18.0;  // [mm] over which normals are averaged

}  // namespace myoface
