// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "head_field.h"
#include "mesh_builder.h"

namespace myoface {

constexpr double kIrisAngle = 0.505;  ///< half angle seen from the eyeball's centre [rad]
constexpr double kPupilAngle = 0.165;

/// The left eyeball with its cornea. @param around vertices on a parallel
void add_eyeball(MeshBuilder& builder, const Vec3& centre, int around);

/// The pink mound in the inner corner of the left eye.
void add_caruncle(MeshBuilder& builder, const Vec3& inner_canthus, const Vec3& eye_centre,
                  int around);

/// Left half of the upper or lower row of teeth, seven of them; centre of the row at the lips'
/// contact. @cite nelson_ash_2010 for breadths and heights of crowns
void add_teeth(MeshBuilder& builder, const Vec3& mid_lips, bool upper, int around);

/// Left half of the gum over a row of teeth.
void add_gum(MeshBuilder& builder, const Vec3& mid_lips, bool upper, int around);

}  // namespace myoface
