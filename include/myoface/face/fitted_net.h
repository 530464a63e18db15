// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <utility>
#include <vector>

#include "myoface/face/face_model.h"

namespace myoface {

/// The average head's front as a net on this face, and how far the scan is from it.
struct FittedNet {
    Points points;                             ///< 3×N [mm]
    Eigen::VectorXd distance;                  ///< N, to the scan [mm]
    std::vector<std::pair<int, int>> threads;  ///< neighbours
};
/// @param spacing of the net on the average head [mm]
FittedNet fitted_net(const FaceModel& face, double spacing = 4.0);

}  // namespace myoface
