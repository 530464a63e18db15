// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <utility>
#include <vector>

#include "myoface/face/face_model.h"

namespace myoface {

/// Vertices of an open mouth that face each other across the slit: upper and lower.
/// @param lips the surroundings of the mouth @param generic its vertices on the average head
std::vector<std::pair<int, int>> find_lip_contacts(const TriangleMesh& lips, const Points& generic);

/// Which lip a node belongs to, told along the surface: both margins lie at the same place.
/// Takes what is known from `face.lip_side`, and nothing else where no lips touch.
std::vector<signed char> find_lip_sides(const FaceModel& face);

}  // namespace myoface
