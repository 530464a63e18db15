// SPDX-License-Identifier: Apache-2.0
#include "portrait.h"

#include <algorithm>

namespace myoface::cli {

void cover_eyes(Image& picture, const Camera& camera, const Landmarks& landmarks) {
    constexpr double kAround = 14.0;  // [mm]
    const Vec3 right = camera.orientation * Vec3::UnitX();
    const Vec3 up = camera.orientation * Vec3::UnitY();
    double left = picture.width;
    double most = 0.0;
    double top = picture.height;
    double bottom = 0.0;
    for (const char* name : {"en_l", "en_r", "ex_l", "ex_r"}) {
        const auto found = landmarks.find(name);
        if (found == landmarks.end()) {
            continue;
        }
        for (const double side : {-1.0, 1.0}) {
            const PixelPoint p =
                project(camera, found->second.position + side * kAround * (right + up),
                        picture.width, picture.height);
            left = std::min(left, p.x);
            most = std::max(most, p.x);
            top = std::min(top, p.y);
            bottom = std::max(bottom, p.y);
        }
    }
    for (int y = std::max(0, static_cast<int>(top));
         y < std::min(picture.height, static_cast<int>(bottom)); ++y) {
        for (int x = std::max(0, static_cast<int>(left));
             x < std::min(picture.width, static_cast<int>(most)); ++x) {
            std::uint8_t* pixel = &picture.rgba[4 * (static_cast<std::size_t>(y) *
                                                         static_cast<std::size_t>(picture.width) +
                                                     static_cast<std::size_t>(x))];
            std::fill(pixel, pixel + 3, std::uint8_t{12});
        }
    }
}

}  // namespace myoface::cli
