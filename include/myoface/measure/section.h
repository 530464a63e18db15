// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "myoface/face/face_model.h"

namespace myoface {

/// A plane through a face with the axes in which its cut is drawn.
struct SectionPlane {
    Vec3 through = Vec3::Zero();  ///< [mm]
    Vec3 normal = Vec3::UnitX();  ///< unit
    Vec3 right = -Vec3::UnitZ();  ///< unit, in the plane
    Vec3 up = Vec3::UnitY();      ///< unit, in the plane
};

/// The profile in the midplane, which looks to the left.
SectionPlane profile_plane(const FaceModel& face);
/// Level through a place, seen from below as on tomograms: the patient's left is on the right.
SectionPlane horizontal_plane(const FaceModel& face, const Vec3& through);
/// Beside the midplane, through a place; looks to the left as the profile does.
SectionPlane sagittal_plane(const FaceModel& face, const Vec3& through);
/// Any other. @param normal of any length but 0
SectionPlane free_plane(const FaceModel& face, const Vec3& through, const Vec3& normal);

/// A cut of the skin: lines in the plane, in millimetres from `through` along right and up.
using SectionLine = std::vector<Eigen::Vector2d>;

/// The skin that is seen, without linings of mouth, nose and lids.
Triangles seen_skin(const FaceModel& face);

/// Cuts the front of the face; pieces that hang together are one line, a closed one ends where it
/// begins. @param skin triangles of seen_skin() @param nodes 3×nodes, the skin's first [mm]
std::vector<SectionLine> section(const FaceModel& face, const Triangles& skin, const Points& nodes,
                                 const SectionPlane& plane);

/// The largest distance from a point of `now` to the lines of `before` [mm]; 0 without lines.
double largest_gap(const std::vector<SectionLine>& before, const std::vector<SectionLine>& now);

/// "state,line,right_mm,up_mm" with a row per point.
std::string section_csv(const std::vector<SectionLine>& before,
                        const std::vector<SectionLine>& now);

}  // namespace myoface
