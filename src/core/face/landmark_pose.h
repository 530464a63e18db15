// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "myoface/face/landmarks.h"
#include "myoface/face/smooth_warp.h"
#include "myoface/mesh/triangle_mesh.h"

namespace myoface {

/// Landmarks that a face has in common with the average head.
struct LandmarkPairs {
    std::vector<std::string> names;
    Points scan, generic;    ///< 3×N [mm]
    Eigen::VectorXd errors;  ///< of those on the scan [mm]
};
LandmarkPairs common_landmarks(const Landmarks& landmarks);

/// Size and pose of a face: scan -> average head.
/// @throws InvalidInput when the landmarks are too few, mirrored, or do not lie as on a face
Similarity pose_of(const Landmarks& landmarks);

/// Many label sets call the deepest point of the nasal root "nasion"; the true one lies higher.
/// Which one was meant shows in its height over the inner canthi: names it rightly.
void settle_nasion(Landmarks& landmarks, const Similarity& to_generic);

/// @throws InvalidInput when a landmark lies far off the skin
void check_near(const Landmarks& landmarks, const TriangleMesh& skin);

}  // namespace myoface
