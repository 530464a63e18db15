// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

namespace myoface {

/// Dark blue over green to yellow, evenly growing in lightness, for 0 … 1 (clamped). sRGB.
Eigen::Vector3f colour_map(double value);

/// What was taken away in blue, what was added in orange, for −1 … 1 (clamped): colour and how much
/// it covers, nothing at 0. sRGB. Both ends look different to colour-blind eyes too.
Eigen::Vector4f signed_tint(double value);

/// A colour for a muscle's label, well apart from its neighbours'. sRGB.
Eigen::Vector3f label_colour(int muscle);

}  // namespace myoface
