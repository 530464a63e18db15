// SPDX-License-Identifier: Apache-2.0
#include "head_variation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

#include "myoface/base/smooth_step.h"

#include "head_contour.h"
#include "head_mesh.h"

namespace myoface {
namespace {

/// A man's share; a woman's is its opposite.
constexpr double kJaw = 34.0;
std::span<const ContourHandle> masculine_handles() {
    static const std::array<ContourHandle, 13> kHandles{{
        {{0, 36, 101}, 22, {0, 0, 2.6}},     // glabella
        {{24, 37, 95}, 22, {0, -0.8, 3.0}},  // brow ridge
        {{40, 36, 84}, 20, {0.8, -0.4, 1.8}},
        {{0, 70, 97}, 38, {0, 0, -2.6}},  // forehead leans back
        {{26, 66, 95}, 34, {0, 0, -1.6}},
        {{50, -64, 14}, kJaw, {3.2, -1.6, 0}},  // angle of the jaw
        {{42, -74, 44}, 30, {2.4, -1.4, 1.0}},
        {{17, -92, 84}, 24, {2.4, -0.6, 1.0}},  // square chin
        {{0, -90, 95}, 20, {0, -1.0, 1.6}},
        {{38, -14, 80}, 28, {0, 0, -2.2}},  // flatter cheek
        {{30, -44, 84}, 24, {0, 0, -1.2}},
        {{45, -120, 0}, 70, {4.4, 0, 2.0}},  // neck
        {{0, -120, -70}, 60, {0, 0, -4.0}},
    }};
    return kHandles;
}

std::span<const ContourHandle> old_handles() {
    static const std::array<ContourHandle, 12> kHandles{{
        {{30, 27, 86}, 15, {0, -1.6, -0.6}},    // skin over the upper lid sinks
        {{40, 33, 84}, 18, {0, -1.8, -0.4}},    // outer brow
        {{27, 5, 84}, 13, {0, -0.6, 1.6}},      // bag under the eye
        {{27, -4, 84}, 12, {0, 0, -1.6}},       // groove below it
        {{50, 30, 66}, 26, {-1.8, 0, -1.6}},    // temple
        {{46, -24, 66}, 30, {-1.4, 0, -2.2}},   // hollow cheek
        {{32, -36, 84}, 18, {0.6, -1.6, 1.6}},  // fold beside the mouth
        {{34, -72, 66}, 22, {1.8, -2.6, 1.6}},  // jowl
        {{24, -78, 78}, 12, {0, 0.8, -1.4}},    // notch before it
        {{0, -104, 52}, 32, {0, -3.0, 2.4}},    // under the chin
        {{11, -118, 34}, 24, {2.0, 0, 3.0}},    // bands of the throat
        {{0, -20, 114}, 18, {0, -1.2, 0}},      // nose tip
    }};
    return kHandles;
}

/// A fold: a groove along a curve of the frontal view, raised on its outer side.
struct Fold {
    std::vector<Eigen::Vector2d> curve;  ///< (|x|, y) in the space of the head's curves
    double depth, width;                 ///< [mm]
    double ridge;                        ///< height of the roll beside it, share of the depth
};

const std::vector<Fold>& old_folds() {
    static const std::vector<Fold> kFolds{
        {{{18, -17}, {23, -25}, {28.5, -34}, {32, -44}, {33, -52}}, 1.7, 3.2, 0.6},  // nasolabial
        {{{27.5, -55}, {29, -62}, {28, -70}, {26, -77}}, 1.0, 2.6, 0.4},             // marionette
        {{{3, 57}, {16, 58.5}, {30, 57.5}, {44, 53}}, 0.45, 1.5, 0.5},               // forehead
        {{{2, 66}, {16, 68}, {30, 67}, {46, 61}}, 0.5, 1.6, 0.5},
        {{{4, 76}, {18, 77.5}, {32, 76}, {44, 70}}, 0.4, 1.6, 0.5},
        {{{5.5, 30}, {6.5, 36}, {6, 43}}, 0.5, 1.3, 0.5},   // frown
        {{{47, 19}, {53, 23}, {58, 26.5}}, 0.4, 1.2, 0.4},  // crow's feet
        {{{47, 15}, {54, 14.5}, {60, 14}}, 0.4, 1.2, 0.4},
        {{{46, 11}, {52, 6.5}, {57, 2}}, 0.35, 1.2, 0.4},
        {{{20, 8}, {27, 3}, {36, 3.5}}, 0.5, 1.8, 0.4},  // tear trough
    };
    return kFolds;
}

/// Signed distance from a curve (positive on its left) and how far inside its ends, 0 … 1.
struct CurvePlace {
    double off = std::numeric_limits<double>::infinity();
    double inside = 0.0;
};
CurvePlace place_on(const Fold& fold, const Eigen::Vector2d& at) {
    CurvePlace best;
    const auto spans = static_cast<double>(fold.curve.size() - 1);
    for (std::size_t i = 0; i + 1 < fold.curve.size(); ++i) {
        const Eigen::Vector2d a = fold.curve[i];
        const Eigen::Vector2d ab = fold.curve[i + 1] - a;
        const double t = std::clamp((at - a).dot(ab) / ab.squaredNorm(), 0.0, 1.0);
        const Eigen::Vector2d away = at - a - t * ab;
        if (away.norm() < std::abs(best.off)) {
            const double side = ab.x() * away.y() - ab.y() * away.x();
            best.off = std::copysign(away.norm(), side);
            const double along = (static_cast<double>(i) + t) / spans;
            best.inside = smooth_step(0.0, 0.25, along) * smooth_step(1.0, 0.75, along);
        }
    }
    return best;
}

double fold_height(const Vec3& q) {
    if (q.z() < 40.0) {
        return 0.0;
    }
    double height = 0.0;
    for (const Fold& fold : old_folds()) {
        const CurvePlace place = place_on(fold, {std::abs(q.x()), q.y()});
        const double r = place.off / fold.width;
        if (std::abs(r) > 4.0) {
            continue;
        }
        const double groove = -std::exp(-r * r);
        const double roll = fold.ridge * std::exp(-(std::abs(r) - 1.7) * (std::abs(r) - 1.7));
        height += fold.depth * place.inside * (groove + roll);
    }
    return height;
}

}  // namespace

Vec3 variation_shift(const HeadVariation& variation, const Vec3& p, const Vec3& normal) {
    static const std::array<ContourHandle, 1> kLarynx{{{{0, -124, 34}, 24, {0, -1, 4.0}}}};
    Vec3 shift = variation.masculine * contour_shift(masculine_handles(), p);
    if (variation.masculine > 0.0) {
        shift += variation.masculine * contour_shift(kLarynx, p);
    }
    if (variation.old > 0.0) {
        shift += variation.old * contour_shift(old_handles(), p);
        shift += variation.old * fold_height(average_head().in_primitives(p)) * normal;
    }
    return shift;
}

}  // namespace myoface
