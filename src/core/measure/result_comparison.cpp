// SPDX-License-Identifier: Apache-2.0
#include "myoface/measure/result_comparison.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "myoface/base/error.h"
#include "myoface/base/parallel.h"
#include "myoface/mesh/bvh.h"
#include "myoface/mesh/normals.h"

namespace myoface {
namespace {

constexpr double kNoneOpposite = 15.0;  // [mm] where the result has no skin opposite
constexpr double kMostResidual = 2.0;   // [mm] that registration may leave
constexpr int kMatchRounds = 40;
constexpr int kComparisonGrain = 256;

Eigen::Isometry3d rigid(const Points& from, const Points& to) {
    return Eigen::Isometry3d(Eigen::umeyama(from, to, false));
}

/// Nodes of forehead and nasal root.
std::vector<int> steady_nodes(const FaceModel& face) {
    constexpr double kRoot = 18.0;  // [mm] around the nasion
    std::vector<int> nodes;
    const auto n = face.landmarks.find("n");
    for (int i = 0; i < face.own_nodes; ++i) {
        const bool forehead = face.tissue[static_cast<std::size_t>(i)].region == Region::Forehead;
        const bool root = n != face.landmarks.end() &&
                          (face.skin.mesh.vertices.col(i) - n->second.position).norm() < kRoot;
        if (forehead || root) {
            nodes.push_back(i);
        }
    }
    return nodes;
}

/// One round of closest points: the steady four fifths of the face's points that lie best are laid
/// on the planes of the result's triangles, which lets the result slide into place.
/// @return how far it was moved @cite chen_1992
double lay_closer(const TriangleMesh& result, const Bvh& bvh, const Points& skin,
                  const std::vector<int>& steady, ResultComparison& comparison) {
    struct Pair {
        double away;
        Vec3 face, result, normal;
    };
    const Eigen::Isometry3d back = comparison.to_face.inverse();
    std::vector<Pair> pairs(steady.size());
    parallel_for(static_cast<int>(steady.size()), kComparisonGrain, [&](int begin, int end) {
        for (int k = begin; k < end; ++k) {
            const Vec3 place = skin.col(steady[static_cast<std::size_t>(k)]);
            const ClosestPoint closest = bvh.closest_point(result, back * place);
            const Vec3 normal = double_area_vector(result, closest.where.triangle).normalized();
            const Vec3 there = comparison.to_face * closest.point;
            pairs[static_cast<std::size_t>(k)] = {(there - place).norm(), place, there,
                                                  comparison.to_face.linear() * normal};
        }
    });
    std::sort(pairs.begin(), pairs.end(),
              [](const Pair& a, const Pair& b) { return a.away < b.away; });
    pairs.resize(std::max<std::size_t>(12, pairs.size() * 8 / 10));
    Vec3 centre = Vec3::Zero();
    for (const Pair& pair : pairs) {
        centre += pair.result / static_cast<double>(pairs.size());
    }
    constexpr double kArm = 50.0;  // makes turns as large as shifts [mm]
    Eigen::Matrix<double, 6, 6> normal_equations = Eigen::Matrix<double, 6, 6>::Zero();
    Eigen::Matrix<double, 6, 1> right = Eigen::Matrix<double, 6, 1>::Zero();
    double sum = 0.0;
    for (const Pair& pair : pairs) {
        Eigen::Matrix<double, 6, 1> row;
        row << (pair.result - centre).cross(pair.normal) / kArm, pair.normal;
        const double off = pair.normal.dot(pair.face - pair.result);
        normal_equations += row * row.transpose();
        right += off * row;
        sum += pair.away * pair.away;
    }
    comparison.registration_mm = std::sqrt(sum / static_cast<double>(pairs.size()));
    // A little damping holds what no point says anything about.
    normal_equations.diagonal().array() += 1e-4 * static_cast<double>(pairs.size());
    const Eigen::Matrix<double, 6, 1> step = normal_equations.ldlt().solve(right);
    const Vec3 turn = step.head<3>() / kArm;
    const Eigen::Isometry3d motion =
        Eigen::Translation3d(centre + step.tail<3>()) *
        Eigen::AngleAxisd(turn.norm(),
                          turn.norm() > 0.0 ? Vec3(turn.normalized()) : Vec3(Vec3::UnitX())) *
        Eigen::Translation3d(-centre);
    comparison.to_face = motion * comparison.to_face;
    return step.norm();
}

}  // namespace

ResultComparison compare_with_result(const FaceModel& face, const Points& plan,
                                     const TriangleMesh& result,
                                     const Landmarks& result_landmarks) {
    std::vector<std::pair<Vec3, Vec3>> pairs;
    for (const auto& [name, landmark] : result_landmarks) {
        const auto own = face.landmarks.find(name);
        if (own != face.landmarks.end()) {
            pairs.emplace_back(landmark.position, own->second.position);
        }
    }
    if (pairs.size() < 4) {
        throw InvalidInput("The result has too few landmarks in common with the face.");
    }
    Points from(3, static_cast<Eigen::Index>(pairs.size()));
    Points to(3, from.cols());
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        from.col(static_cast<Eigen::Index>(i)) = pairs[i].first;
        to.col(static_cast<Eigen::Index>(i)) = pairs[i].second;
    }
    ResultComparison comparison;
    comparison.to_face = rigid(from, to);

    // Closest points on the result from the steady part of the face as it was before.
    const Bvh bvh(result);
    const std::vector<int> steady = steady_nodes(face);
    if (steady.size() < 20) {
        throw InvalidInput(
            "The face shows too little of forehead and nasal root to lay a result "
            "on it.");
    }
    for (int round = 0; round < kMatchRounds; ++round) {
        const double change = lay_closer(result, bvh, face.skin.mesh.vertices, steady, comparison);
        if (change < 1e-7) {
            break;
        }
    }
    if (!(comparison.registration_mm < kMostResidual)) {
        throw InvalidInput("The result does not fit on forehead and nasal root of this face: " +
                           std::to_string(std::lround(comparison.registration_mm)) +
                           " mm are left. Is it the same patient, and are its unit and landmarks "
                           "right?");
    }

    const int nodes = face.node_count();
    const Points skin = plan.leftCols(nodes);
    const Points normals = vertex_normals({skin, face.skin.mesh.triangles}, *face.adjacency);
    comparison.distance.resize(nodes);
    const Eigen::Isometry3d back = comparison.to_face.inverse();
    parallel_for(nodes, kComparisonGrain, [&](int begin, int end) {
        for (int i = begin; i < end; ++i) {
            const Vec3 place = back * skin.col(i);
            const ClosestPoint closest = bvh.closest_point(result, place);
            const Vec3 way = comparison.to_face.linear() * (closest.point - place);
            comparison.distance[i] = way.norm() < kNoneOpposite
                                         ? std::copysign(way.norm(), way.dot(normals.col(i)))
                                         : std::numeric_limits<double>::quiet_NaN();
        }
    });

    comparison.regions = distances_by_region(face, comparison.distance);
    if (comparison.regions.empty()) {
        throw InvalidInput("The result has no skin opposite the face.");
    }
    return comparison;
}

}  // namespace myoface
