// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

#include "myoface/face/face_model.h"

namespace myoface {

/// Whether something closes the mouth behind the lips, so that one does not look through it at the
/// inside of the head.
bool has_mouth_bag(const TriangleMesh& scan, const std::function<Vec3(const Vec3&)>& from_generic);

/// What is seen behind open lips: a bag from the lips back to the throat, around the teeth.
MouthLining mouth_lining(const std::function<Vec3(const Vec3&)>& from_generic);

}  // namespace myoface
