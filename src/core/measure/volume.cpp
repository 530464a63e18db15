// SPDX-License-Identifier: Apache-2.0
#include "myoface/measure/volume.h"

#include <cmath>

namespace myoface {
namespace {

double swept(const Triangles& triangles, Eigen::Index t, const Points& before,
             const Points& after) {
    Vec3 way = Vec3::Zero();
    for (int c = 0; c < 3; ++c) {
        way += (after.col(triangles(c, t)) - before.col(triangles(c, t))) / 3.0;
    }
    const auto area = [&](double share) {
        const auto at = [&](int c) {
            const int v = triangles(c, t);
            return Vec3((1.0 - share) * before.col(v) + share * after.col(v));
        };
        return Vec3(0.5 * (at(1) - at(0)).cross(at(2) - at(0)));
    };
    // Simpson's rule.
    return way.dot(area(0.0) + 4.0 * area(0.5) + area(1.0)) / 6.0;
}

}  // namespace

double swept_volume(const Triangles& triangles, const Points& before, const Points& after) {
    double sum = 0.0;
    for (Eigen::Index t = 0; t < triangles.cols(); ++t) {
        sum += swept(triangles, t, before, after);
    }
    return sum;
}

std::map<Region, double> volume_by_region(const FaceModel& face, const Points& before,
                                          const Points& after) {
    constexpr double kCubicMillimetres = 1000.0;  // in a millilitre
    constexpr double kNothing = 0.002;            // [mL]
    const Triangles& triangles = face.skin.mesh.triangles;
    std::map<Region, double> volumes;
    for (Eigen::Index t = 0; t < triangles.cols(); ++t) {
        const auto region = [&](int c) {
            return face.tissue[static_cast<std::size_t>(triangles(c, t))].region;
        };
        const Region most = region(1) == region(2) ? region(1) : region(0);
        volumes[most] += swept(triangles, t, before, after) / kCubicMillimetres;
    }
    std::erase_if(volumes, [&](const auto& entry) { return std::abs(entry.second) < kNothing; });
    return volumes;
}

}  // namespace myoface
