// SPDX-License-Identifier: Apache-2.0
#include "myoface/muscle/response.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

#include "myoface/base/error.h"

namespace myoface {
namespace {
constexpr double kQuarter = 0.5 * std::numbers::pi;
}

std::string response_name(ResponseForm form) {
    switch (form) {
        case ResponseForm::AsPrinted:
            return "as printed";
        case ResponseForm::QuarterTurn:
            return "quarter turn";
        case ResponseForm::Waters1987:
            return "1987";
        case ResponseForm::ZoneNormalised:
            return "zone-normalised";
        case ResponseForm::LaterCode:
            return "later code";
        default:
            return "smooth";
    }
}

ResponseForm response_named(const std::string& name) {
    const auto plain = [](std::string text) {
        std::replace(text.begin(), text.end(), '-', ' ');
        return text;
    };
    std::string known;
    for (const ResponseForm form : kResponseForms) {
        if (plain(name) == plain(response_name(form))) {
            return form;
        }
        known += (known.empty() ? "" : ", ") + response_name(form);
    }
    throw InvalidInput("'" + name + "' is no form of the response; known are " + known + ".");
}

double radial_response(double distance, double falloff_start, double falloff_end,
                       ResponseForm form) noexcept {
    assert(0.0 < falloff_start && falloff_start < falloff_end);
    if (distance < 0.0 || distance > falloff_end) {
        return 0.0;
    }
    const bool inner = distance <= falloff_start;
    const double out = (distance - falloff_start) / (falloff_end - falloff_start);
    switch (form) {
        case ResponseForm::AsPrinted:
            return inner ? std::cos(1.0 - distance / falloff_start) : std::cos(out);
        case ResponseForm::LaterCode:
            return distance / falloff_start * (inner ? 1.0 : std::cos(kQuarter * out));
        case ResponseForm::Smooth: {
            const double half =
                inner ? std::sin(kQuarter * distance / falloff_start) : std::cos(kQuarter * out);
            return half * half;
        }
        default:
            return inner ? std::cos(kQuarter * (1.0 - distance / falloff_start))
                         : std::cos(kQuarter * out);
    }
}

double angular_response(double angle, double half_angle, ResponseForm form) noexcept {
    if (angle > half_angle) {
        return 0.0;
    }
    switch (form) {
        case ResponseForm::AsPrinted:
        case ResponseForm::QuarterTurn:
            return std::cos(angle);
        case ResponseForm::Waters1987:
            return std::cos(0.5 * angle);
        case ResponseForm::ZoneNormalised:
            return std::cos(kQuarter * angle / half_angle);
        case ResponseForm::LaterCode:
            return (std::cos(angle) / std::cos(half_angle) - 1.0) /
                   (1.0 / std::cos(half_angle) - 1.0);
        default: {
            const double c = std::cos(kQuarter * angle / half_angle);
            return c * c;
        }
    }
}

Vec3 linear_response(const ResponseZone& zone, const Vec3& point, ResponseForm form) noexcept {
    const Vec3 to_bone = zone.bone_end - point;
    const double distance = to_bone.norm();
    const Vec3 along = zone.skin_end - zone.bone_end;
    if (!(distance > 1e-12) || distance > zone.falloff_end || !(along.norm() > 0.0)) {
        return Vec3::Zero();
    }
    const double cosine = std::clamp(-along.dot(to_bone) / (along.norm() * distance), -1.0, 1.0);
    const double angle = std::acos(cosine);
    const double size = angular_response(angle, zone.half_angle, form) *
                        radial_response(distance, zone.falloff_start, zone.falloff_end, form);
    return size / distance * to_bone;
}

Vec3 sphincter_response(const SphincterZone& zone, const Vec3& point) noexcept {
    const Vec3 offset = point - zone.centre;
    const Vec3 high = zone.axis.cross(zone.wide);
    const double x = offset.dot(zone.wide);
    const double y = offset.dot(high);
    const double z = offset.dot(zone.axis);
    const double square = std::pow(x / zone.half_width, 2.0) + std::pow(y / zone.half_height, 2.0);
    const double away = std::abs(z) / zone.depth;
    if (square >= 1.0 || away >= 1.0) {
        return Vec3::Zero();
    }
    const double fade = (1.0 - away * away) * (1.0 - away * away);
    const double w = (1.0 - square) * (1.0 - square) * fade;
    // max of ρ (1 − ρ²)² is 16/(25 √5), reached along the longer axis
    const double peak =
        16.0 / (25.0 * std::sqrt(5.0)) * std::max(zone.half_width, zone.half_height);
    return -w / peak * (x * zone.wide + (y > 0.0 ? zone.across_high : zone.across_low) * y * high) +
           zone.forward * w * zone.axis;
}

}  // namespace myoface
