// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "myoface/mesh/triangle_mesh.h"

#include "head_field.h"
#include "mesh_builder.h"

namespace myoface {

/// Lines along which the left half of the head ends; numbers as in RemeshOptions::lines.
enum HeadLine { kMidline = 1, kUpperLid, kLowerLid, kUpperLip, kLowerLip };

/// The left half's surface with its openings cut, and the line of each vertex.
struct CutHead {
    TriangleMesh mesh;
    std::vector<int> lines;
};

/// The curves that the openings follow, in the space of the finished head.
class OpeningCurves {
public:
    explicit OpeningCurves(const HeadField& head);
    /// Nearest point of a lid margin or of the line where the lips meet.
    Vec3 nearest(const Vec3& p, int line) const;
    Vec3 inner_canthus() const { return upper_lid_.front(); }
    Vec3 outer_canthus() const { return upper_lid_.back(); }
    Vec3 mid_lips() const { return lips_.front(); }
    Vec3 mouth_corner() const { return lips_.back(); }
    const std::vector<Vec3>& upper_lid() const { return upper_lid_; }
    const std::vector<Vec3>& lower_lid() const { return lower_lid_; }

private:
    std::vector<Vec3> upper_lid_, lower_lid_, lips_;  ///< dense polylines, from medial
};

/// Opens eye and mouth of the left half of the head; `closed` ends on x = 0 only.
CutHead cut_openings(const TriangleMesh& closed, const HeadField& head,
                     const OpeningCurves& curves);

/// Lid margins: from the skin's border rounded inwards to the eyeball, and on behind the lids.
/// Appends to `builder` and returns the number of the first new vertex.
int add_lid_margins(MeshBuilder& builder, const CutHead& half, const Vec3& eye_centre);

/// The inside of the lips and the mouth bag, closed at the back. As above.
int add_mouth_bag(MeshBuilder& builder, const CutHead& half);

}  // namespace myoface
