// SPDX-License-Identifier: Apache-2.0
#include "skin_resolution.h"

#include <algorithm>
#include <cmath>

#include "myoface/base/parallel.h"
#include "myoface/mesh/coarse_mesh.h"

namespace myoface {
namespace {

/// How far every vertex may be from a node at a place of the average head [mm]: nodes are a third
/// further apart. Lips and lids fold most, the back of the head does not move.
float spacing_at(const Vec3& p) {
    constexpr double kFront = 1.4;
    constexpr double kFine = 1.0;
    constexpr double kCoarsest = 5.0;
    constexpr double kGrowth = 0.06;  // per millimetre away from the front
    const auto beyond = [&](const Vec3& low, const Vec3& high) {
        return (p - p.cwiseMax(low).cwiseMin(high)).norm();
    };
    constexpr double kFar = 400.0;
    const double front = beyond({-66.0, -90.0, 30.0}, {66.0, 66.0, kFar});
    const double lips = beyond({-32.0, -76.0, 45.0}, {32.0, -36.0, kFar});
    const double eyes = std::min(beyond({14.0, 6.0, 45.0}, {46.0, 28.0, kFar}),
                                 beyond({-46.0, 6.0, 45.0}, {-14.0, 28.0, kFar}));
    const double coarse = kFront + kGrowth * front;
    const double fine = kFine + kGrowth * std::min(lips, eyes);
    return static_cast<float>(std::min({coarse, fine, kCoarsest}));
}

SimulatedSkin whole(const WeldedMesh& part) {
    SimulatedSkin skin;
    skin.mesh = part.mesh;
    const auto count = static_cast<Eigen::Index>(part.of_vertex.size());
    skin.between.setConstant(3, count, -1);
    skin.shares.setZero(3, count);
    for (Eigen::Index v = 0; v < count; ++v) {
        skin.between(0, v) = part.of_vertex[static_cast<std::size_t>(v)];
        skin.shares(0, v) = 1.0F;
    }
    return skin;
}

SimulatedSkin fewer(const WeldedMesh& part, const Similarity& to_generic,
                    std::vector<std::pair<int, int>>& lips) {
    constexpr double kContacts = 1.0;  // [mm] from one pair of the lips to the next
    const int n = part.mesh.vertex_count();
    Eigen::VectorXf spacing(n);
    parallel_for(n, 4096, [&](int begin, int end) {
        for (int v = begin; v < end; ++v) {
            spacing[v] = spacing_at(to_generic(Vec3(part.mesh.vertices.col(v)))) /
                         static_cast<float>(to_generic.scale);
        }
    });
    std::vector<std::pair<int, int>> pairs;
    std::vector<int> kept;
    for (const auto& [upper, lower] : lips) {
        const Vec3 at = part.mesh.vertices.col(upper);
        const Vec3 there = part.mesh.vertices.col(lower);
        const bool near = std::any_of(pairs.begin(), pairs.end(), [&](const auto& pair) {
            return (part.mesh.vertices.col(pair.first) - at).norm() < kContacts ||
                   (part.mesh.vertices.col(pair.second) - there).norm() < kContacts;
        });
        if (!near) {
            pairs.emplace_back(upper, lower);
            kept.push_back(upper);
            kept.push_back(lower);
        }
    }
    CoarseMesh coarse = coarsen(part.mesh, spacing, kept);
    lips.clear();
    for (const auto& [upper, lower] : pairs) {
        lips.emplace_back(coarse.between(0, upper), coarse.between(0, lower));
    }
    SimulatedSkin skin;
    skin.mesh = std::move(coarse.mesh);
    const auto count = static_cast<Eigen::Index>(part.of_vertex.size());
    skin.between.setConstant(3, count, -1);
    skin.shares.setZero(3, count);
    for (Eigen::Index v = 0; v < count; ++v) {
        const int welded = part.of_vertex[static_cast<std::size_t>(v)];
        if (welded >= 0) {
            skin.between.col(v) = coarse.between.col(welded);
            skin.shares.col(v) = coarse.shares.col(welded);
        }
    }
    skin.surroundings.resize(coarse.fine.size());
    return skin;
}

}  // namespace

SimulatedSkin simulated_skin(const WeldedMesh& part, const Similarity& to_generic, int finest,
                             std::vector<std::pair<int, int>>& lips) {
    SimulatedSkin skin =
        part.mesh.vertex_count() <= finest ? whole(part) : fewer(part, to_generic, lips);
    skin.vertex.assign(static_cast<std::size_t>(skin.mesh.vertex_count()), -1);
    for (Eigen::Index v = skin.between.cols() - 1; v >= 0; --v) {
        if (skin.between(0, v) >= 0 && skin.between(1, v) < 0) {
            skin.vertex[static_cast<std::size_t>(skin.between(0, v))] = static_cast<int>(v);
        }
    }
    return skin;
}

}  // namespace myoface
