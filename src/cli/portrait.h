// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "myoface/face/landmarks.h"
#include "myoface/io/image.h"
#include "myoface/scene/camera.h"

namespace myoface::cli {

/// A black bar from the outermost to the innermost corner of the eyes that a picture shows.
void cover_eyes(Image& picture, const Camera& camera, const Landmarks& landmarks);

}  // namespace myoface::cli
