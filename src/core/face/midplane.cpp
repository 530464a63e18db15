// SPDX-License-Identifier: Apache-2.0
#include "myoface/face/midplane.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include "myoface/base/error.h"
#include "myoface/base/parallel.h"

namespace myoface {

Vec3 mirrored(const Midplane& plane, const Vec3& p) {
    return p - 2.0 * side_of(plane, p) * plane.normal;
}

double side_of(const Midplane& plane, const Vec3& p) {
    return plane.normal.dot(p - plane.point);
}

Midplane midplane_of(const Landmarks& landmarks) {
    const auto weight = [](const Landmark& landmark) {
        return 1.0 / (1.0 + landmark.error_mm * landmark.error_mm);
    };
    Vec3 left = Vec3::Zero();
    std::vector<std::pair<Vec3, double>> middle;
    for (const auto& [name, landmark] : landmarks) {
        if (name.ends_with("_l")) {
            const auto other = landmarks.find(mirrored_name(name));
            if (other != landmarks.end()) {
                const double both = std::min(weight(landmark), weight(other->second));
                left += both * (landmark.position - other->second.position);
                middle.emplace_back(0.5 * (landmark.position + other->second.position), both);
            }
        } else if (!name.ends_with("_r")) {
            middle.emplace_back(landmark.position, weight(landmark));
        }
    }
    if (!(left.norm() > 1e-9)) {
        throw InvalidInput("The midplane needs at least one landmark on both sides.");
    }
    // Normal: least spread of the middle points, held to the direction of the pairs.
    Vec3 mean = Vec3::Zero();
    double sum = 0.0;
    for (const auto& [p, w] : middle) {
        mean += w * p;
        sum += w;
    }
    mean /= sum;
    Mat3 spread = Mat3::Zero();
    for (const auto& [p, w] : middle) {
        spread += w * (p - mean) * (p - mean).transpose();
    }
    Midplane plane;
    plane.point = mean;
    plane.normal = left.normalized();
    const double hold = 0.25 * left.squaredNorm();  // pairs are far apart: they tell most
    const Mat3 across = Mat3::Identity() - plane.normal * plane.normal.transpose();
    const Mat3 system = across * spread * across + hold * Mat3::Identity();
    plane.normal -= system.ldlt().solve(across * (spread * plane.normal));
    plane.normal.normalize();
    return plane;
}

Midplane refined(const Midplane& start, const TriangleMesh& surface, const Bvh& bvh,
                 const Points& points) {
    constexpr int kRounds = 12;
    constexpr double kKept = 0.66;
    constexpr double kFarthest = 8.0;  // [mm]
    const auto n = static_cast<std::size_t>(points.cols());
    if (n < 50) {
        return start;
    }
    struct Pair {
        Eigen::Vector3d slope;  // of the residual by two turns and the shift
        double residual = 0.0, distance = 0.0;
    };
    Midplane plane = start;
    const double reach = (points.colwise() - points.rowwise().mean()).colwise().norm().mean();
    for (int round = 0; round < kRounds; ++round) {
        const Vec3 a = plane.normal.unitOrthogonal();
        const Vec3 b = plane.normal.cross(a);
        std::vector<Pair> pairs(n);
        parallel_for(static_cast<int>(n), 64, [&](int begin, int end) {
            for (int i = begin; i < end; ++i) {
                const Vec3 p = points.col(i);
                const Vec3 image = mirrored(plane, p);
                const ClosestPoint hit = bvh.closest_point(surface, image);
                const Vec3 normal = double_area_vector(surface, hit.where.triangle).normalized();
                const Vec3 arm = p - plane.point;
                const double off = plane.normal.dot(arm);
                const auto turned = [&](const Vec3& axis) {
                    return normal.dot(-2.0 * (axis.dot(arm) * plane.normal + off * axis));
                };
                pairs[static_cast<std::size_t>(i)] = {
                    {turned(a), turned(b), normal.dot(2.0 * plane.normal)},
                    normal.dot(image - hit.point),
                    hit.distance};
            }
        });
        std::vector<double> distances;
        for (const Pair& pair : pairs) {
            distances.push_back(pair.distance);
        }
        const auto at = distances.begin() + static_cast<std::ptrdiff_t>(kKept * (n - 1));
        std::nth_element(distances.begin(), at, distances.end());
        const double most = std::min(*at, kFarthest);
        Mat3 matrix = Mat3::Zero();
        Vec3 vector = Vec3::Zero();
        for (const Pair& pair : pairs) {
            if (pair.distance <= most) {
                matrix += pair.slope * pair.slope.transpose();
                vector -= pair.residual * pair.slope;
            }
        }
        // A flat or round surface says little about some directions: stay there.
        const double little = 1e-3 * static_cast<double>(n);
        matrix.diagonal() += Vec3(little * reach * reach, little * reach * reach, little);
        const Vec3 step = matrix.ldlt().solve(vector);
        if (!step.allFinite()) {
            break;
        }
        plane.normal = (plane.normal + step.x() * a + step.y() * b).normalized();
        plane.point += step.z() * plane.normal;
        if (step.norm() < 1e-6) {
            break;
        }
    }
    return plane;
}

}  // namespace myoface
