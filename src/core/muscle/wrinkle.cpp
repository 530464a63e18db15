// SPDX-License-Identifier: Apache-2.0
#include "myoface/muscle/wrinkle.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "myoface/base/parallel.h"
#include "myoface/mesh/triangle_mesh.h"

namespace myoface {
namespace {

// Skin takes up some shortening by itself, less the older it is; of what is left the old skin folds
// all, the young one little.
constexpr double kTakenYoung = 0.05, kTakenOld = 0.015;
constexpr double kFoldsYoung = 0.08, kFoldsOld = 1.0;
constexpr double kOnset = 0.04;  // shortening over which folding sets in
constexpr double kMost = 0.25;   // shortening that furrows take up in the end; the rest is bulk
constexpr double kActs = 0.1;    // contraction from which on a muscle acts fully
// ∫ of the squared slope of a profile of unit width and depth: (1 − t²) e^(−t²/2), t e^(−t²/2).
constexpr double kSlopes = 3.3234, kSlopesOfLean = 1.3293;

Vec3 at(const WrinkleMap::Place& place, const Points& nodes) {
    return place.weight[0] * nodes.col(place.node[0]) + place.weight[1] * nodes.col(place.node[1]) +
           place.weight[2] * nodes.col(place.node[2]);
}

double length(const WrinkleMap::Gauge& gauge, const Points& nodes) {
    return (at(gauge.high, nodes) - at(gauge.low, nodes)).norm();
}

/// ¼, ½, ¼ along each furrow.
Eigen::VectorXd evened(const WrinkleMap& map, const Eigen::VectorXd& values) {
    Eigen::VectorXd result = values;
    for (std::size_t f = 0; f + 1 < map.first.size(); ++f) {
        for (int i = map.first[f]; i < map.first[f + 1]; ++i) {
            const double before = values[std::max(i - 1, map.first[f])];
            const double after = values[std::min(i + 1, map.first[f + 1] - 1)];
            result[i] = 0.25 * before + 0.5 * values[i] + 0.25 * after;
        }
    }
    return result;
}

/// Normals of the nodes that the map asks for; the others stay undefined.
Points normals_at(const FaceModel& face, const std::vector<int>& which, const Points& nodes) {
    Points normals(3, face.node_count());
    const Triangles& triangles = face.skin.mesh.triangles;
    parallel_for(static_cast<int>(which.size()), 1024, [&](int begin, int end) {
        for (int k = begin; k < end; ++k) {
            Vec3 sum = Vec3::Zero();
            for (const int t : face.adjacency->triangles(which[k])) {
                const Vec3 a = nodes.col(triangles(0, t));
                sum += (nodes.col(triangles(1, t)) - a).cross(nodes.col(triangles(2, t)) - a);
            }
            normals.col(which[k]) = sum.normalized();
        }
    });
    return normals;
}

}  // namespace

Eigen::VectorXd shortening(const WrinkleMap& map, const Points& rest, const Points& now) {
    Eigen::VectorXd result(static_cast<Eigen::Index>(map.gauges.size()));
    for (std::size_t g = 0; g < map.gauges.size(); ++g) {
        const double before = length(map.gauges[g], rest);
        result[static_cast<Eigen::Index>(g)] =
            before > 0.0 ? std::max(0.0, 1.0 - length(map.gauges[g], now) / before) : 0.0;
    }
    return evened(map, evened(map, result));
}

Eigen::VectorXd furrow_drive(const FaceModel& face, const Contractions& contractions) {
    const std::vector<FurrowTraits>& atlas = furrow_atlas();
    Eigen::VectorXd drive = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(atlas.size()));
    for (std::size_t f = 0; f < atlas.size(); ++f) {
        double sum = 0.0;
        for (const int m : atlas[f].muscles) {
            const auto muscle = static_cast<std::size_t>(m);
            if (muscle < face.muscles.size()) {
                sum += std::max(0.0, contractions.rate[muscle] * contractions.strength[muscle]);
            }
        }
        const double share = std::min(1.0, sum / kActs);
        drive[static_cast<Eigen::Index>(f)] = share * share * (3.0 - 2.0 * share);
    }
    return drive;
}

Eigen::VectorXd furrow_depths(const WrinkleMap& map, const Eigen::VectorXd& shortening,
                              const Eigen::VectorXd& drive, double skin_age) {
    const double age =
        std::clamp((skin_age - kYoungestSkin) / (kOldestSkin - kYoungestSkin), 0.0, 1.0);
    const double taken = kTakenYoung + age * (kTakenOld - kTakenYoung);
    const double folds = kFoldsYoung + age * (kFoldsOld - kFoldsYoung);
    Eigen::VectorXd depth = Eigen::VectorXd::Zero(shortening.size());
    for (Eigen::Index g = 0; g < depth.size(); ++g) {
        const double left = shortening[g] - taken;
        const int furrow = map.gauges[static_cast<std::size_t>(g)].furrow;
        if (left <= 0.0 || drive[furrow] <= 0.0) {
            continue;
        }
        const FurrowTraits& traits = furrow_atlas()[static_cast<std::size_t>(furrow)];
        const double seen = std::clamp((skin_age - traits.first_age) / 15.0, 0.0, 1.0);
        // A furrow of depth d and width w is ½ d² C / w longer than the straight way.
        const double set_in = left * left / (left + kOnset);
        const double longer = folds * set_in / (1.0 + set_in / kMost) * 2.0 * traits.gauge;
        const double slopes = kSlopes + kSlopesOfLean * traits.lean * traits.lean;
        depth[g] =
            seen * drive[furrow] * traits.share * std::sqrt(2.0 * longer * traits.width / slopes);
    }
    return depth;
}

Eigen::VectorXd wrinkle_heights(const Wrinkles& wrinkles) {
    const WrinkleMap& map = *wrinkles.map;
    const auto count = static_cast<int>(map.vertices.size());
    Eigen::VectorXd heights(count);
    parallel_for(count, 4096, [&](int begin, int end) {
        for (int k = begin; k < end; ++k) {
            double sum = 0.0;
            for (int e = map.start[k]; e < map.start[k + 1]; ++e) {
                sum += static_cast<double>(map.height[e]) * wrinkles.depth[map.gauge[e]];
            }
            heights[k] = sum;
        }
    });
    return heights;
}

void add_wrinkles(const FaceModel& face, const Wrinkles& wrinkles, const Points& nodes,
                  Points& vertices) {
    if (wrinkles.none()) {
        return;
    }
    const WrinkleMap& map = *wrinkles.map;
    const Eigen::VectorXd heights = wrinkle_heights(wrinkles);
    const Points normals = normals_at(face, map.of_node, nodes);
    parallel_for(static_cast<int>(map.vertices.size()), 2048, [&](int begin, int end) {
        for (int k = begin; k < end; ++k) {
            if (heights[k] == 0.0) {
                continue;
            }
            const int v = map.vertices[k];
            Vec3 outward = normals.col(face.skin.between(0, v));
            if (face.skin.between(1, v) >= 0) {
                outward *= static_cast<double>(face.skin.shares(0, v));
                for (int c = 1; c < 3 && face.skin.between(c, v) >= 0; ++c) {
                    outward += static_cast<double>(face.skin.shares(c, v)) *
                               normals.col(face.skin.between(c, v));
                }
                outward.normalize();
            }
            vertices.col(v) += heights[k] * outward;
        }
    });
}

}  // namespace myoface
