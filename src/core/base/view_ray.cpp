// SPDX-License-Identifier: Apache-2.0
#include "myoface/base/view_ray.h"

#include <numbers>

#include "myoface/base/error.h"

namespace myoface {

Eigen::Quaterniond standard_view(const std::string& name) {
    constexpr double kQuarter = 0.5 * std::numbers::pi;
    const auto turned = [](double yaw, double pitch) {
        return Eigen::Quaterniond(Eigen::AngleAxisd(yaw, Vec3::UnitY()) *
                                  Eigen::AngleAxisd(pitch, Vec3::UnitX()));
    };
    if (name == "front") {
        return turned(0.0, 0.0);
    }
    if (name == "left") {
        return turned(kQuarter, 0.0);
    }
    if (name == "right") {
        return turned(-kQuarter, 0.0);
    }
    if (name == "three-quarter-left") {
        return turned(0.5 * kQuarter, 0.0);
    }
    if (name == "three-quarter-right") {
        return turned(-0.5 * kQuarter, 0.0);
    }
    if (name == "below") {
        return turned(0.0, 0.55 * kQuarter);
    }
    if (name == "above") {
        return turned(0.0, -0.55 * kQuarter);
    }
    if (name == "back") {
        return turned(2.0 * kQuarter, 0.0);
    }
    throw InvalidInput("There is no view '" + name +
                       "': use front, left, right, three-quarter-left, three-quarter-right, "
                       "below, above or back.");
}

}  // namespace myoface
