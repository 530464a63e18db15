// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "myoface/face/landmarks.h"

#include "head_field.h"

namespace myoface {

/// Landmarks of the average head, found on its surface by what they mean: the foremost point of the
/// chin, the deepest between columella and lip. They do not depend on any mesh.
Landmarks place_landmarks(const HeadField& head);

}  // namespace myoface
