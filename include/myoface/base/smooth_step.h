// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

namespace myoface {

/// 0 below the first edge, 1 above the second, in between the cubic 3t² − 2t³, which has no kink.
/// The edges may come the other way round, which turns it.
inline double smooth_step(double edge0, double edge1, double x) {
    const double t = std::clamp((x - edge0) / (edge1 - edge0), 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

}  // namespace myoface
