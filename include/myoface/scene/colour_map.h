// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

namespace myoface {

/// Dark blue over green to yellow, evenly growing in lightness, for 0 … 1 (clamped). sRGB.
Eigen::Vector3f colour_map(double value);

/// A colour for a muscle's label, well apart from its neighbours'. sRGB.
Eigen::Vector3f label_colour(int muscle);

}  // namespace myoface
