// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

#include "myoface/face/face_model.h"

#include "sliding_surface.h"

namespace myoface {

/// Carries the atlas onto the face: warped points are dropped onto the skin and pushed in, the bone
/// end by the tissue's depth, the skin end a little, what lies between in proportion.
void place_muscles(FaceModel& face, const Points& smooth_normals,
                   const std::function<Vec3(const Vec3&)>& from_generic);

/// Gives every skin node the label of the muscle that lies nearest under it, if one does.
void label_skin(FaceModel& face);

/// Skull-like surface: the smoothed skin, inward by the tissue's depth; open at orbits, nose and
/// mouth, without ears.
TriangleMesh bone_surface(const FaceModel& face, const SmoothFace& smooth);

}  // namespace myoface
