// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "myoface/face/face_model.h"
#include "myoface/mesh/triangle_mesh.h"

namespace myoface {

/// Skull of the average head: what lies under its skin at the depths of the tissue table, smooth in
/// between, with orbits, nasal aperture and cheek arches; the mandible is a piece of its own, and
/// both have their teeth.
struct Skull {
    TriangleMesh mesh;           ///< [mm], the generic head's frame
    std::vector<BonePart> part;  ///< per vertex
    /// Per vertex: a place on the skin above it, which it follows on a scan.
    Points skin;
};

/// Made once. @throws IoError when the program's own table of depths is damaged
const Skull& generic_skull();

/// Where the tissue table measures: places on the average head's skin, outward normals there and
/// depths to bone.
struct DepthSites {
    Points places;           ///< 3×N, pairs twice
    Points normals;          ///< 3×N
    Eigen::VectorXd depths;  ///< [mm]
    std::vector<char> bony;  ///< 0 where the depth is that of cartilage
};
const DepthSites& depth_sites();

/// The hinge through the mandible's condyles, in the generic head's frame.
JawHinge generic_jaw_hinge();

}  // namespace myoface
