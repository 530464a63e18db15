// SPDX-License-Identifier: Apache-2.0
#include "landmark_sharpening.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

namespace myoface {
namespace {

/// Depth of the face over a grid in its own front view [mm].
class FrontView {
public:
    /// @param deepest what lies behind this is seen through a gap and counts as this deep [mm]
    FrontView(const TriangleMesh& mesh, const Bvh& bvh, double deepest)
        : mesh_(mesh), bvh_(bvh), deepest_(deepest) {}

    double depth(double x, double y) const {
        const auto hit = bvh_.first_hit(mesh_, {Vec3(x, y, 250.0), -Vec3::UnitZ()});
        return hit ? std::max(250.0 - hit->distance, deepest_) : deepest_;
    }

    /// How much lower the skin lies at a height than 3 mm above and below it [mm].
    double valley(double x, double y) const {
        return 0.5 * (depth(x, y + 3.0) + depth(x, y - 3.0)) - depth(x, y);
    }

private:
    const TriangleMesh& mesh_;
    const Bvh& bvh_;
    double deepest_;
};

constexpr double kGap = 3.0;  // [mm] what is deeper is no crease but a gap

/// A crease across the view, from its middle to both ends.
struct Crease {
    Vec3 middle, left, right;
    double relief = 0.0;  ///< usual one, see FrontView::valley() [mm]
};

/// Follows the crease between closed lips or lids, or the gap between open ones, from near `middle`
/// outwards to where it fades.
std::optional<Crease> follow_crease(const FrontView& view, const Vec3& middle) {
    constexpr double kStep = 0.5;
    constexpr double kDeep = kGap;   // [mm] a gap counts as a crease so deep
    constexpr double kShare = 0.38;  // of its usual relief that the crease keeps up to the corner
    const auto valley = [&](double x, double y) { return std::min(view.valley(x, y), kDeep); };
    // Near where the fit expects it: the groove above the upper lip is a valley too.
    double start = middle.y();
    double likely = 0.0;
    for (double y = middle.y() - 8.0; y <= middle.y() + 8.0; y += kStep) {
        const double off = (y - middle.y()) / 5.0;
        const double value = valley(middle.x(), y) * std::exp(-off * off);
        if (value > likely) {
            likely = value;
            start = y;
        }
    }
    if (valley(middle.x(), start) < 0.4) {
        return std::nullopt;
    }
    Crease crease;
    crease.middle = {middle.x(), start, view.depth(middle.x(), start)};
    std::vector<Vec3> path[2];  // x, y, relief
    std::vector<double> usual;
    for (const int side : {0, 1}) {
        double y = start;
        for (double off = 1.0; off <= 38.0; off += 0.5) {
            const double x = middle.x() + (side == 0 ? off : -off);
            // The foot of the fold beside the mouth goes on downwards: the nearest of equals.
            Vec3 best(x, y, -1.0);
            for (double at = y - 1.0; at <= y + 1.0; at += 0.25) {
                const double value = valley(x, at) - 0.1 * std::abs(at - y);
                if (value > best.z()) {
                    best = {x, at, value};
                }
            }
            y = best.y();
            path[side].push_back(best);
            if (off < 14.0) {
                usual.push_back(best.z());
            }
        }
    }
    std::nth_element(usual.begin(), usual.begin() + static_cast<std::ptrdiff_t>(usual.size() / 2),
                     usual.end());
    crease.relief = usual[usual.size() / 2];
    const double least = kShare * crease.relief;
    for (const int side : {0, 1}) {
        Vec3 corner = crease.middle;
        int missing = 0;
        for (const Vec3& at : path[side]) {
            if (at.z() < least) {
                if (++missing > 4) {
                    break;
                }
                continue;
            }
            missing = 0;
            // The skin beside the gap, not what is seen through it.
            corner = {at.x(), at.y(),
                      std::max(view.depth(at.x(), at.y() + 1.5), view.depth(at.x(), at.y() - 1.5))};
        }
        (side == 0 ? crease.left : crease.right) = corner;
    }
    return crease;
}

/// The face's outline in its midplane, foremost point at each height.
class Profile {
public:
    /// @param top, bottom points of the midline that bound it
    Profile(const FrontView& view, const Vec3& top, const Vec3& bottom)
        : high_(top.y()), x_(top.x()), slope_((bottom.x() - top.x()) / (bottom.y() - top.y())) {
        const auto count = static_cast<int>((top.y() - bottom.y()) / kStep) + 1;
        std::vector<double> rough;
        for (int i = 0; i < count; ++i) {
            const double y = high_ - kStep * i;
            std::array<double, 5> planes{};
            for (int k = 0; k < 5; ++k) {
                planes[static_cast<std::size_t>(k)] = view.depth(x_at(y) + 0.8 * (k - 2), y);
            }
            std::nth_element(planes.begin(), planes.begin() + 2, planes.end());
            rough.push_back(planes[2]);
        }
        for (int i = 0; i < count; ++i) {  // a Gaussian of 0.8 mm
            double sum = 0.0;
            double weights = 0.0;
            for (int k = std::max(0, i - 4); k <= std::min(count - 1, i + 4); ++k) {
                const double off = kStep * (k - i) / 0.8;
                const double weight = std::exp(-0.5 * off * off);
                sum += weight * rough[static_cast<std::size_t>(k)];
                weights += weight;
            }
            z_.push_back(sum / weights);
        }
    }

    Vec3 at(double y) const {
        const auto i = static_cast<std::ptrdiff_t>(std::lround((high_ - y) / kStep));
        const auto last = static_cast<std::ptrdiff_t>(z_.size()) - 1;
        return {x_at(y), y, z_[static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(i, 0, last))]};
    }

    /// The point between two others that stands out furthest before (sign 1) or behind (sign -1)
    /// the straight line through them; nothing without at least `relief` [mm].
    std::optional<Vec3> furthest(const Vec3& upper, const Vec3& lower, double sign,
                                 double relief) const {
        const Eigen::Vector2d along =
            Eigen::Vector2d(lower.z() - upper.z(), lower.y() - upper.y()).normalized();
        const Eigen::Vector2d out(-along.y(), along.x());  // towards +z for a line that goes down
        std::optional<Vec3> best;
        double most = relief;
        for (double y = upper.y() - 1.0; y >= lower.y() + 1.0; y -= kStep) {
            const Vec3 p = at(y);
            const double height =
                sign * out.dot(Eigen::Vector2d(p.z() - upper.z(), p.y() - upper.y()));
            if (height > most) {
                most = height;
                best = p;
            }
        }
        return best;
    }

private:
    static constexpr double kStep = 0.5;  // [mm]
    double x_at(double y) const { return x_ + slope_ * (y - high_); }

    double high_, x_, slope_;
    std::vector<double> z_;
};

/// Puts landmarks of the midline where the profile turns, as they are defined; a turn that is not
/// there or far from where it is expected is left out. @cite farkas_1994
void sharpen_midline(Places& places, const FrontView& view) {
    constexpr double kFarthest = 7.0;  // [mm]
    const Profile profile(view, places.at("prn") + Vec3(0.0, 12.0, 0.0),
                          places.at("gn") - Vec3(0.0, 4.0, 0.0));
    const auto move = [&](const char* name, const std::optional<Vec3>& to, double share) {
        Vec3& place = places.at(name);
        if (to && std::abs(to->y() - place.y()) < kFarthest) {
            const double y = place.y() + share * (to->y() - place.y());
            place = {place.x(), y, profile.at(y).z()};
        }
    };
    const auto on = [&](const char* name) { return profile.at(places.at(name).y()); };
    move("sn", profile.furthest(on("prn"), on("ls"), -1.0, 0.7), 0.7);
    move("ls", profile.furthest(on("sn"), on("sto"), 1.0, 0.5), 0.7);
    const std::optional<Vec3> fold = profile.furthest(on("li"), on("pg"), -1.0, 0.5);
    move("sl", fold, 0.7);
    if (fold) {
        move("li", profile.furthest(on("sto"), *fold, 1.0, 0.3), 0.5);
    }
}

/// Draws the inner canthi to where the slit between the lids ends, as far as it is seen. Outwards
/// it runs out into folds that tell nothing.
void sharpen_inner_canthi(Places& places, const TriangleMesh& mesh, const Bvh& bvh) {
    constexpr double kTrust = 0.5;
    constexpr double kFarthest = 6.0;  // [mm]
    for (const char* side : {"_l", "_r"}) {
        Vec3& inner = places.at(std::string("en") + side);
        const Vec3 middle = 0.5 * (inner + places.at(std::string("ex") + side));
        // An open eye is as deep as its ball at most.
        const FrontView view(mesh, bvh, middle.z() - 9.0);
        const std::optional<Crease> slit = follow_crease(view, middle);
        if (!slit) {
            continue;
        }
        const Vec3& end = inner.x() > middle.x() ? slit->left : slit->right;
        if (std::abs(end.x() - middle.x()) > 8.0 && (end - inner).head<2>().norm() < kFarthest) {
            inner += kTrust * (end - inner);
        }
    }
}

/// Height of the gap between the lips in the midplane [mm].
double gap_height(const FrontView& view, const Vec3& middle) {
    constexpr double kStep = 0.5;
    constexpr double kHigh = 40.0;    // [mm] no mouth opens further from where it is looked at
    constexpr double kBehind = 18.0;  // [mm] no lip lies so far behind the other
    double front = -1e9;
    for (double y = middle.y() - 12.0; y <= middle.y() + 12.0; y += kStep) {
        front = std::max(front, view.depth(middle.x(), y));
    }
    const auto open = [&](double y) { return view.depth(middle.x(), y) < front - kBehind; };
    if (!open(middle.y())) {
        return 0.0;
    }
    double height = kStep;
    for (const double way : {kStep, -kStep}) {
        for (double off = way; std::abs(off) < kHigh && open(middle.y() + off); off += way) {
            height += kStep;
        }
    }
    return height;
}

/// @return height of the gap [mm]
double sharpen_mouth(Places& places, const FrontView& view) {
    const Vec3 lips = places.at("sto");
    const std::optional<Crease> crease = follow_crease(view, lips);
    if (!crease) {
        return 0.0;
    }
    places.at("sto").y() = crease->middle.y();
    for (const auto& [name, corner] :
         {std::pair("ch_l", crease->left), std::pair("ch_r", crease->right)}) {
        // A crease that fades early says nothing.
        const bool seen = std::abs(corner.x() - lips.x()) > 12.0;
        if (seen && (corner - places.at(name)).head<2>().norm() < 14.0) {
            places.at(name) = corner;
        }
    }
    return gap_height(view, crease->middle);
}

}  // namespace

double sharpen(Places& places, const TriangleMesh& mesh, const Bvh& bvh) {
    const FrontView view(mesh, bvh, places.at("sto").z() - 30.0);
    const double gap = sharpen_mouth(places, view);
    sharpen_inner_canthi(places, mesh, bvh);
    sharpen_midline(places, view);
    // The tip is seen from the front: behind it lie the nostrils.
    places.at("prn").z() = view.depth(places.at("prn").x(), places.at("prn").y());
    return gap;
}

}  // namespace myoface
