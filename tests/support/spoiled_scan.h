// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

#include "myoface/base/points.h"
#include "myoface/face/landmarks.h"
#include "myoface/mesh/triangle_mesh.h"

namespace myoface::test {

/// A scan of a generated person as a scanner would hand it over: of any size of mesh, with noise,
/// holes, cut edges, loose scraps, tufts of hair, a mild expression, in any turn and place.
struct SpoiledScan {
    TriangleMesh mesh;
    Landmarks truth;    ///< on the mesh, moved with it
    double unit = 1.0;  ///< of the mesh [mm]
    Mat3 turn = Mat3::Identity();
    std::string story;  ///< what was done, for messages
};

/// The same seed gives the same scan.
SpoiledScan spoiled_scan(std::uint32_t seed);

}  // namespace myoface::test
