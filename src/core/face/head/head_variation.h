// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "myoface/base/points.h"

namespace myoface {

/// What age and sex change between the landmarks, which the norms do not tell.
struct HeadVariation {
    double masculine = 0.0;  ///< -1 woman … 1 man
    double old = 0.0;        ///< 0 young … 1 old
};

/// Way of a place of the average head's surface [mm]. Smooth; mirror-symmetric.
Vec3 variation_shift(const HeadVariation& variation, const Vec3& p, const Vec3& normal);

}  // namespace myoface
