// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <Eigen/Geometry>

#include "myoface/measure/region_distance.h"

namespace myoface {

/// A plan beside what came of it.
struct ResultComparison {
    Eigen::Isometry3d to_face;  ///< lays the result on the face
    double registration_mm =
        0.0;  ///< what is left at forehead and nasal root, root mean square [mm]
    Eigen::VectorXd
        distance;  ///< per skin node, along its normal; NaN where the result has no skin
    std::vector<RegionDistance> regions;  ///< the whole face first
};

/// Lays a scan of afterwards on the face without changing its size, by landmarks and then by
/// forehead and nasal root, which operations on the lower face leave alone, and measures the way
/// from each place of the plan to it. Scalp, ears and neck do not count.
/// @param plan 3×nodes, the skin's first [mm] @throws InvalidInput when they do not come together
/// @cite chen_1992
ResultComparison compare_with_result(const FaceModel& face, const Points& plan,
                                     const TriangleMesh& result, const Landmarks& result_landmarks);

}  // namespace myoface
