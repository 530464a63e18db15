// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "myoface/base/progress.h"
#include "myoface/mesh/triangle_mesh.h"

namespace myoface {

/// From where light reaches each place of a surface, for soft shadows of nose, brow and chin
/// whatever way the lamps stand: the share of light from a unit direction d that arrives at vertex
/// v is about column(v)[3] + column(v).head(3) · d, between 0 and 1. Least squares over rays into
/// the half space outside; (0, 0, 0, 1) where everything is open. The same on any number of
/// threads.
/// @throws Cancelled
Eigen::Matrix4Xf light_visibility(const TriangleMesh& mesh, const Progress* progress = nullptr);

}  // namespace myoface
