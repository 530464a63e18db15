// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

#include "myoface/face/face_model.h"

#include "sliding_surface.h"

namespace myoface {

/// The scan without mouth bag and nostrils; all vertices, fewer triangles.
TriangleMesh outer_skin(const FaceModel& face);

/// Carries the atlas onto the face: warped points are dropped onto the skin and pushed in, the bone
/// end by the tissue's depth, the skin end a little, what lies between in proportion.
void place_muscles(FaceModel& face, const Points& smooth_normals,
                   const std::function<Vec3(const Vec3&)>& from_generic);

/// Gives every skin node the muscles that lie under it, with weights; the strongest is its label.
void label_skin(FaceModel& face);

}  // namespace myoface
