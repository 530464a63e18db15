// SPDX-License-Identifier: Apache-2.0
#include "myoface/scene/colour_map.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace myoface {

Eigen::Vector3f colour_map(double value) {
    static const std::array<Eigen::Vector3f, 6> kStops{{{0.17F, 0.11F, 0.36F},
                                                        {0.16F, 0.29F, 0.56F},
                                                        {0.10F, 0.48F, 0.56F},
                                                        {0.20F, 0.65F, 0.48F},
                                                        {0.60F, 0.79F, 0.30F},
                                                        {0.98F, 0.91F, 0.25F}}};
    const auto at = static_cast<float>(std::clamp(value, 0.0, 1.0) * (kStops.size() - 1));
    const auto low = std::min(static_cast<std::size_t>(at), kStops.size() - 2);
    const float share = at - static_cast<float>(low);
    return (1.0F - share) * kStops[low] + share * kStops[low + 1];
}

Eigen::Vector4f signed_tint(double value) {
    const auto size = static_cast<float>(std::min(std::abs(value), 1.0));
    const Eigen::Vector3f pale =
        value < 0.0 ? Eigen::Vector3f(0.55F, 0.76F, 0.95F) : Eigen::Vector3f(0.99F, 0.80F, 0.50F);
    const Eigen::Vector3f full =
        value < 0.0 ? Eigen::Vector3f(0.06F, 0.25F, 0.62F) : Eigen::Vector3f(0.80F, 0.30F, 0.04F);
    Eigen::Vector4f tint;
    tint << (1.0F - size) * pale + size * full, std::min(1.0F, 3.0F * size);
    return tint;
}

Eigen::Vector3f label_colour(int muscle) {
    // The golden angle keeps successive hues apart.
    const double hue = std::fmod(0.02 + 0.381966 * muscle, 1.0) * 6.0;
    const auto channel = [&](double n) {
        const double k = std::fmod(n + hue, 6.0);
        return 0.86 - 0.52 * std::clamp(std::min(k, 4.0 - k), 0.0, 1.0);
    };
    return Eigen::Vector3d(channel(5.0), channel(3.0), channel(1.0)).cast<float>();
}

}  // namespace myoface
