// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "myoface/base/points.h"
#include "myoface/face/landmarks.h"
#include "myoface/mesh/bvh.h"

namespace myoface {

/// The plane between the halves of a face: that of this patient, not of the file's axes.
struct Midplane {
    Vec3 point = Vec3::Zero();    ///< [mm]
    Vec3 normal = Vec3::UnitX();  ///< unit, to the patient's left
};

/// Mirror image of a place.
Vec3 mirrored(const Midplane& plane, const Vec3& p);
/// Distance from the plane, positive on the patient's left [mm].
double side_of(const Midplane& plane, const Vec3& p);

/// The plane that fits landmarks best: pairs are mirror images, midline points lie on it. Weighted
/// by the landmarks' errors. @throws InvalidInput without any pair
Midplane midplane_of(const Landmarks& landmarks);

/// Improves a plane so that the mirror image of `points` lies on the surface as well as can be;
/// the third that lies worst does not count, so that a swelling on one side does not turn it.
/// @param points of the surface, of both halves
/// @cite benz_2002
Midplane refined(const Midplane& start, const TriangleMesh& surface, const Bvh& bvh,
                 const Points& points);

}  // namespace myoface
