// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "myoface/base/progress.h"
#include "myoface/face/face_model.h"

namespace myoface {

/// How far the skin stands out over the mirror image of the other side about the face's own
/// midplane (negative: behind it), along its normal [mm]; per skin node, NaN where the mirror image
/// has no skin near. The same on any number of threads. @param nodes 3×nodes, the skin's first [mm]
/// @throws Cancelled @cite benz_2002
Eigen::VectorXd side_differences(const FaceModel& face, const Points& nodes,
                                 const Progress* progress = nullptr);

}  // namespace myoface
