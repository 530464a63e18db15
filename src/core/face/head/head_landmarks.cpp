// SPDX-License-Identifier: Apache-2.0
#include "head_landmarks.h"

#include <string>
#include <vector>

namespace myoface {
namespace {

/// Midline profile from one height down to another.
std::vector<Vec3> profile(const HeadField& head, double top, double bottom) {
    std::vector<Vec3> points;
    constexpr double kStep = 0.05;
    for (double y = top; y > bottom; y -= kStep) {
        points.push_back(head.front_point(0.0, y));
    }
    return points;
}

/// The point furthest along a direction.
Vec3 extreme(const std::vector<Vec3>& points, const Vec3& direction) {
    Vec3 best = points.front();
    for (const Vec3& p : points) {
        if (p.dot(direction) > best.dot(direction)) {
            best = p;
        }
    }
    return best;
}

/// The point furthest behind the straight line between the two ends.
Vec3 deepest(const std::vector<Vec3>& points) {
    const Vec3 along = points.back() - points.front();
    return extreme(points,
                   Vec3(0.0, along.z(), -along.y()).normalized() * (along.y() > 0.0 ? 1.0 : -1.0));
}

}  // namespace

Landmarks place_landmarks(const HeadField& head) {
    Landmarks result;
    const auto put = [&](const std::string& name, const Vec3& at) {
        constexpr double kError = 0.1;  // [mm]
        result[name] = {at, kError};
    };
    const auto pair = [&](const std::string& name, const Vec3& at) {
        put(name + "_l", at);
        put(name + "_r", {-at.x(), at.y(), at.z()});
    };
    put("tr", head.front_point(0, 86));
    put("g", extreme(profile(head, 48, 30), Vec3::UnitZ()));
    const Vec3 root = head.front_point(0, 25);
    put("n", root);
    const Vec3 tip = extreme(profile(head, -8, -26), Vec3::UnitZ());
    put("prn", tip);
    std::vector<Vec3> bridge = profile(head, root.y() + 8.0, 4.0);
    put("se", deepest(bridge));
    const Vec3 lip = head.front_point_at(0, -45.2);
    std::vector<Vec3> base{head.front_point(0, -25.5)};
    for (const Vec3& p : profile(head, -27.5, lip.y())) {
        base.push_back(p);
    }
    const Vec3 subnasale = deepest(base);
    put("sn", subnasale);
    put("c", head.front_point(0, subnasale.y() + 4.8));
    put("ls", lip);
    put("sto", head.front_point_at(0, head.lip_line(0)));
    const Vec3 lower = head.front_point_at(0, -60);
    put("li", lower);
    const Vec3 chin = extreme(profile(head, -75, -92), Vec3::UnitZ());
    put("sl", deepest(profile(head, lower.y(), chin.y())));
    put("pg", chin);
    std::vector<Vec3> under;
    for (double angle = 0.0; angle < 1.5; angle += 0.02) {
        under.push_back(head.onto_surface(
            Vec3(0, -80, 78) + 18.0 * Vec3(0, -std::sin(angle), std::cos(angle)), true));
    }
    put("gn", extreme(under, Vec3(0, -0.85, 0.53)));
    pair("en",
         head.front_point_at(HeadField::kInnerCanthus, head.upper_lid(HeadField::kInnerCanthus)));
    pair("ex",
         head.front_point_at(HeadField::kOuterCanthus, head.upper_lid(HeadField::kOuterCanthus)));
    Vec3 wing = head.onto_surface({20, -21, 98});
    for (double y = -26; y < -18; y += 0.5) {
        for (double z = 97.5; z < 106; z += 0.5) {
            const Vec3 p = head.onto_surface({20, y, z});
            wing = p.x() > wing.x() && p.z() > 97.0 && p.x() < 20.0 && p.y() < -18.0 ? p : wing;
        }
    }
    pair("al", wing);
    pair("ac", head.onto_surface({17, -23, 91.5}));
    pair("sbal", head.front_point(9.2, -30.5));
    pair("ch",
         head.front_point_at(HeadField::kMouthCorner, head.lip_line(HeadField::kMouthCorner)));
    pair("cph", head.front_point_at(6.2, -44.2));
    pair("zy", head.onto_surface({70, -4, 22}));
    // Gonion: the caliper lies under the angle of the jaw, where the head has narrowed to it.
    Vec3 angle = head.onto_surface({60, -60, 12});
    for (double y = -60; y > -90 && angle.x() > 51.0; y -= 0.25) {
        angle = head.onto_surface({angle.x(), y, 12});
    }
    pair("go", angle);
    pair("t", head.onto_surface({71, 0, 3}));
    pair("ft", head.front_point(54.1, 45));
    return result;
}

}  // namespace myoface
