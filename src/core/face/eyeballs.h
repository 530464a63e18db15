// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "myoface/face/face_model.h"

namespace myoface {

/// Eyeballs for the sockets in which the scan has nothing: behind the lids' edges one looks into a
/// hollow. Scanned eyeballs and closed lids stay as they are.
Eyeballs eyeballs_for(const FaceModel& face);

}  // namespace myoface
