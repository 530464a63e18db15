// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "myoface/io/scan.h"
#include "myoface/mesh/weld.h"

namespace myoface {

/// The part that holds the face, as a mesh of its own; other parts (eyeballs, lashes, scraps) ride
/// along unmoved. @param nose a place on the face
WeldedMesh main_part(const Scan& scan, const Vec3& nose);

}  // namespace myoface
