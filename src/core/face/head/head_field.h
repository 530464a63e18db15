// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <Eigen/Geometry>

#include "myoface/base/points.h"

#include "spline.h"

namespace myoface {

/// The generic head as a signed field [mm], negative inside: a lofted base joined smoothly with
/// anatomical primitives. Frame: origin midway between the tragia, Frankfort horizontal y = 0,
/// +x the patient's left, +y up, +z front; symmetric about x = 0. The neck ends at kNeckCut.
class HeadField {
public:
    HeadField();

    double operator()(const Vec3& p) const;
    /// Where a point lay before the contour was corrected: the space of the curves below.
    Vec3 in_primitives(const Vec3& p) const;
    /// The same without lips, lids, nostrils, ears and the soft part of the nose: what the skull
    /// follows.
    double smooth_face(const Vec3& p) const;
    /// A few Newton steps onto the surface. With `keep_x` the point stays in its sagittal plane.
    Vec3 onto_surface(const Vec3& p, bool keep_x = false) const;
    /// Foremost surface point with this x and y.
    Vec3 front_point(double x, double y) const;
    /// The same with x and y in the space of the curves below.
    Vec3 front_point_at(double x, double y) const;
    Vec3 from_primitives(const Vec3& q) const;

    static constexpr double kNeckCut = -150.0;
    Vec3 eye_centre() const { return from_primitives(kEyeCentre); }  ///< left eye
    static constexpr double kEyeRadius = 12.2;

    /// Height of the lid margins and of the line where the lips meet, left side.
    /// Signed distance to the cavity of the nostril, in the space of the curves [mm].
    double nostril(const Vec3& q) const;
    double upper_lid(double x) const { return upper_lid_(x); }
    double lower_lid(double x) const { return lower_lid_(x); }
    double lip_line(double x) const { return lip_line_(x); }
    static constexpr double kMouthCorner = 24.4;
    static constexpr double kInnerCanthus = 16.1;
    static constexpr double kOuterCanthus = 43.6;

    struct Bead {
        Vec3 centre;
        double radius;
    };
    struct Tube {
        std::vector<Bead> beads;
        Eigen::AlignedBox3d box;  ///< around all beads
    };

private:
    inline static const Vec3 kEyeCentre{31.5, 17.2, 68.2};  ///< in the space of the curves

    double primitives(const Vec3& p) const;
    double base(const Vec3& p) const;
    double bony_face(const Vec3& p) const;  ///< base, jaw, brow, cheeks, neck
    double eyes(double d, const Vec3& p) const;
    double nose_ridge(const Vec3& p) const;
    double nose(const Vec3& p) const;
    double ear(const Vec3& p) const;
    double without_lips(const Vec3& p) const;
    double front_z(double x, double y) const;
    Tube snapped(const std::vector<Eigen::Vector4d>& x_y_radius_offset, bool across) const;

    Spline front_, back_, half_width_, width_z_, exponent_;
    Spline ridge_z_, ridge_slope_, ridge_round_;
    Spline upper_lid_, lower_lid_, lip_line_;
    Tube mandible_, brow_, sternomastoid_, alar_groove_, lid_crease_, helix_, antihelix_;
    Tube upper_lip_, lower_lip_, lip_groove_, philtral_column_, philtral_groove_, nasolabial_;
};

}  // namespace myoface
