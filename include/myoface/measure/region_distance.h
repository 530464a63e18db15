// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "myoface/face/face_model.h"

namespace myoface {

/// How far a surface is off in one region of the skin.
struct RegionDistance {
    std::string region;  ///< "whole face" for all of it
    int nodes = 0;
    double mean_mm = 0.0;         ///< of the sizes
    double mean_signed_mm = 0.0;  ///< positive: the result lies outside of the plan
    double p90_mm = 0.0;          ///< 90 of 100 places are closer than this
    double share_below_2mm = 0.0;
};

/// The whole face first, then by region. Scalp, ears, neck and linings do not count, nor does what
/// is not finite; empty when nothing is left. @param distance per skin node [mm], signed
std::vector<RegionDistance> distances_by_region(const FaceModel& face,
                                                const Eigen::VectorXd& distance);

}  // namespace myoface
