// SPDX-License-Identifier: Apache-2.0
#include "head_contour.h"

#include <array>
#include <cmath>

namespace myoface {

namespace {

double pull(const ContourHandle& handle, const Vec3& at, const Vec3& p) {
    if (std::abs(p.x() - at.x()) >= handle.radius || std::abs(p.y() - at.y()) >= handle.radius) {
        return 0.0;
    }
    const double square = (p - at).squaredNorm() / (handle.radius * handle.radius);
    if (square >= 1.0) {
        return 0.0;
    }
    const double r = std::sqrt(square);
    const double rest = (1.0 - r) * (1.0 - r);
    return rest * rest * (4.0 * r + 1.0);
}

}  // namespace

Vec3 contour_shift(std::span<const ContourHandle> handles, const Vec3& p) {
    Vec3 sum = Vec3::Zero();
    for (const ContourHandle& handle : handles) {
        sum += pull(handle, handle.at, p) * handle.move;
        if (handle.at.x() > 0.0) {
            const Vec3 mirror(-1.0, 1.0, 1.0);
            sum +=
                pull(handle, handle.at.cwiseProduct(mirror), p) * handle.move.cwiseProduct(mirror);
        }
    }
    return sum;
}

std::span<const ContourHandle> average_contour() {
    static const std::array<ContourHandle, 25> kHandles{{
        {{0, -37, 99}, 25, {0, 0, 5.5}},   // upper lip over the front teeth
        {{0, -42, 100}, 17, {0, 0, 2.4}},  // above the red of the lip
        {{32, -43, 84}, 32, {0, 0, 5}},    // beside the mouth
        {{32, -8, 82}, 34, {0, 0, 3.2}},   // cheek below the eye
        {{42, -63, 68}, 34, {1, 0, 6}},    // body of the mandible
        {{36, 29, 82}, 26, {0, 0, 4}},     // between brow and lid
        {{58, 34, 58}, 36, {3, 0, 4}},     // behind the rim of the orbit
        {{62, -25, -40}, 42, {-5, 0, 0}},  // behind and below the ear
        {{0, -38, -68}, 44, {0, 0, -4}},   // nape
        {{60, -66, 2}, 46, {-4, 0, 0}},    // neck below the angle of the jaw
        {{26, 60, 97}, 44, {0, 0, -2}},    // forehead
        {{60, -28, 26}, 42, {6, 0, 1}},    // masseter
        {{66, 38, 24}, 50, {6, 0, 2}},     // temple, between orbit and ear
        {{38, -20, 78}, 30, {0, 0, 1.5}},  // cheek
        // The cornea stands well before the outer canthus, the inner canthus in a hollow behind it.
        {{33, 17, 80}, 38, {0, 0, 6.5}},
        {{17, 16, 86}, 16, {0, 0, -5.5}},
        {{13, 15.5, 88}, 14, {0, 0, -1.5}},
        {{46, 17, 76}, 16, {0, 0, -3}},
        {{57, 8, 64}, 34, {1.5, 0, 5}},  // cheekbone beside the orbit
        {{28, 2, 82}, 22, {0, 0, 2.5}},  // below the lower lid
        // The corner of the mouth lies in a hollow between the cheek and the chin.
        {{28, -52, 88}, 34, {0, 0, 2.5}},
        {{22, -40, 92}, 22, {0, 0, 2.5}},
        {{22, -66, 88}, 24, {0, 0, 2.5}},
        {{40, -56, 80}, 30, {0, 0, 3}},
        {{25, -52.2, 90}, 11, {0, 0, -5}},
    }};
    return kHandles;
}

}  // namespace myoface
