// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "myoface/face/landmarks.h"
#include "myoface/face/smooth_warp.h"
#include "myoface/mesh/triangle_mesh.h"

namespace myoface {

/// Maps between the average head and a scan in the average head's pose and size. Not quite inverse
/// to each other.
struct HeadWarps {
    SmoothWarp to_average, from_average;
};

/// Landmarks first, then the front of the head bent onto the scan between them. A bend that would
/// fold is made stiffer. @cite amberg_2007
HeadWarps fit_head(const TriangleMesh& skin, const Similarity& to_generic,
                   const Landmarks& landmarks);

}  // namespace myoface
