// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "myoface/io/image.h"
#include "myoface/scene/camera.h"
#include "myoface/scene/scene.h"

namespace myoface {

/// Draws a scene without a window: through a hidden GLFW window where there is a display, else
/// through surfaceless EGL. From one thread of a process. Drawn at twice the size and averaged, so
/// that edges are smooth.
/// @throws Error when the machine offers no OpenGL 3.3
Image draw_picture(const SceneData& scene, const Camera& camera, int width, int height);

}  // namespace myoface
