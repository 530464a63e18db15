// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "myoface/base/points.h"

#include "head_mesh.h"

namespace myoface {

/// What the skin of the generic head shows besides its shape.
struct HeadLook {
    double masculine = 0.0;  ///< -1 woman … 1 man
    double old = 0.0;        ///< 0 young … 1 old
    double stubble = 0.0;    ///< 0 shaved … 1 three days
    std::uint32_t seed = 0;  ///< of spots and tone
};

/// How far inside a nostril a place of the surface is, in the space of HeadField's curves: 0
/// outside … nearly 1, where hardly any light comes.
double nostril_share(const Vec3& q);

/// Colour in sRGB at a place of the average head. With `fine`, hairs, pores and lashes too, which a
/// picture can hold and a vertex cannot.
Vec3 head_colour(HeadPart part, const Vec3& p, const HeadLook& look, bool fine);

}  // namespace myoface
