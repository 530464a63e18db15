// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "myoface/face/face_model.h"

namespace myoface {

/// How much light comes through open lips to places behind them: 1 at the lips, and less the
/// further back they lie. A smooth guess for pictures, not a computed shadow. @param places 3×N
/// [mm]
Eigen::VectorXd light_behind_lips(const FaceModel& face, const Points& places);

/// How much of that light the gap between the lips lets in: 0 shut … 1 from some millimetres on.
/// @param nodes 3×nodes [mm]
double light_between_lips(const FaceModel& face, const Points& nodes);

/// Soft shadows are computed at rest, where the lips are closed and the mouth behind them is black.
/// Gives what a scan has of teeth, gums and lining the light that open lips would let in.
/// @param of_vertices of light_visibility() of the face's scan
void light_the_mouth(const FaceModel& face, Eigen::Matrix4Xf& of_vertices);

}  // namespace myoface
