// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>

#include "myoface/base/points.h"
#include "myoface/mesh/bvh.h"

namespace myoface {

/// Places of landmarks by their names, in size and pose of the average head [mm].
using Places = std::map<std::string, Vec3>;

/// Moves landmarks from where a smooth fit puts them to where the surface has what defines them:
/// the midline's to the turns of the profile, the corners of the mouth to the ends of the crease
/// between the lips, the inner canthi towards the end of the slit between the lids. What is not
/// seen or lies far off stays. @pre all landmarks of the generic head are there
/// @return height of the gap between the lips [mm], 0 where they are closed
/// @cite farkas_1994
double sharpen(Places& places, const TriangleMesh& mesh, const Bvh& bvh);

}  // namespace myoface
