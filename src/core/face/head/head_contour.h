// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "myoface/base/points.h"

namespace myoface {

/// A soft pull on space: full at `at`, gone at `radius` from it. On the left half, and
/// mirrored, or on the midplane.
struct ContourHandle {
    Vec3 at;
    double radius;  ///< [mm]
    Vec3 move;      ///< [mm]
};

/// Sum of the handles' pulls at a place; C2.
/// @cite wendland_1995
Vec3 contour_shift(std::span<const ContourHandle> handles, const Vec3& p);

/// What brings the head built from primitives to the depths and widths of an average adult between
/// the places that the norms' landmarks hold.
std::span<const ContourHandle> average_contour();

}  // namespace myoface
