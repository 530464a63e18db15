// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string>

#include "myoface/base/points.h"

namespace myoface {

/// Forms of the linear muscle's response in use since 1987. All move a point towards the bone end.
enum class ResponseForm {
    Smooth,          ///< cos²(πα/2Ω) · C1 radial curve: the default
    AsPrinted,       ///< eqs. (7)-(8) as printed: tears at R_f and at the sector's edge
    QuarterTurn,     ///< (7)-(8), the radial cosines scaled to a quarter turn
    Waters1987,      ///< cos(α/2) and quarter-turn radial curve
    ZoneNormalised,  ///< cos(α/Ω · π/2) and quarter-turn radial curve
    LaterCode        ///< (cos α/cos Ω − 1) · D, ramped down beyond R_s; scaled to peak at 1
};
/// "smooth", "as printed", "quarter turn", "1987", "zone-normalised", "later code".
std::string response_name(ResponseForm form);
/// All of them, the default first.
inline constexpr std::array<ResponseForm, 6> kResponseForms{
    ResponseForm::Smooth,     ResponseForm::AsPrinted,      ResponseForm::QuarterTurn,
    ResponseForm::Waters1987, ResponseForm::ZoneNormalised, ResponseForm::LaterCode};
/// The form of that name, with blanks or hyphens. @throws InvalidInput that lists them
ResponseForm response_named(const std::string& name);

/// A linear muscle's zone of influence.
struct ResponseZone {
    Vec3 bone_end = Vec3::Zero();   ///< v1, fixed
    Vec3 skin_end = Vec3::UnitX();  ///< v2
    double half_angle = 0.6;        ///< Ω [rad]
    double falloff_start = 1.0;     ///< R_s [mm]
    double falloff_end = 2.0;       ///< R_f [mm]
};

/// Radial factor alone, as a function of the distance D from the bone end [mm].
double radial_response(double distance, double falloff_start, double falloff_end,
                       ResponseForm form) noexcept;
/// Angular factor alone, α in [0, Ω].
double angular_response(double angle, double half_angle, ResponseForm form) noexcept;

/// Displacement of a point per millimetre of pull, towards the bone end; zero outside the zone.
/// @cite waters_1987, matsuda_muscle_spring Eqs. (7)-(8)
Vec3 linear_response(const ResponseZone& zone, const Vec3& point, ResponseForm form) noexcept;

/// A sphincter's zone: an ellipse in the plane of the ring.
struct SphincterZone {
    Vec3 centre = Vec3::Zero();
    Vec3 wide = Vec3::UnitX();  ///< unit, along the longer semi-axis
    Vec3 axis = Vec3::UnitZ();  ///< unit, normal of the ring
    double half_width = 1.0;    ///< l_x [mm]
    double half_height = 1.0;   ///< l_y [mm]
    double depth = 30.0;        ///< reach along the axis, faded smoothly [mm]
    double forward = 0.0;       ///< part of the pull along the axis
    /// Parts of the pull along the shorter semi-axis, on its positive and negative side.
    double across_high = 1.0, across_low = 1.0;
};

/// Displacement per millimetre of pull: w = (1 − ρ²)², in the plane towards the centre, peak 1, and
/// `forward` · w along the axis. C1, zero at centre and rim.
/// @cite waters_1987 (the ellipse)
Vec3 sphincter_response(const SphincterZone& zone, const Vec3& point) noexcept;

}  // namespace myoface
