// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

#include "myoface/face/face_model.h"

namespace myoface {

/// Carries the skull onto the face: warped by the landmarks, then moved with the scan's skin
/// where there is any, so that the tissue keeps its depth. Sets bone, its parts and the jaw's
/// hinge, the eyeballs and the loose parts that hang on the jaw.
void place_skull(FaceModel& face, const std::function<Vec3(const Vec3&)>& from_generic,
                 TissueThickness thickness);

}  // namespace myoface
