// SPDX-License-Identifier: Apache-2.0
#include "myoface/face/simulated_skin.h"

#include <cmath>

#include <Eigen/LU>

#include "myoface/base/parallel.h"
#include "myoface/mesh/normals.h"

#include "skin_resolution.h"

namespace myoface {
namespace {

constexpr double kStretchedMost = 3.0;  // a motion beyond is no stretch of the surroundings

/// Σ ab ᵀ over the edges at a node and its normal.
Mat3 moments(const Adjacency& adjacency, int node, const Points& at, const Points& normal,
             const Points& rest, const Points& rest_normal) {
    Mat3 sum = Mat3::Zero();
    double square = 0.0;
    const auto neighbours = adjacency.neighbours(node);
    for (const int w : neighbours) {
        const Vec3 edge = rest.col(w) - rest.col(node);
        sum += (at.col(w) - at.col(node)) * edge.transpose();
        square += edge.squaredNorm();
    }
    const double weight =
        neighbours.empty() ? 1.0 : square / static_cast<double>(neighbours.size());
    return sum + weight * normal.col(node) * rest_normal.col(node).transpose();
}

}  // namespace

void prepare_following(SimulatedSkin& skin, const Adjacency& adjacency) {
    const int n = skin.mesh.vertex_count();
    skin.surroundings.resize(static_cast<std::size_t>(n));
    const Points& rest = skin.mesh.vertices;
    for (int i = 0; i < n; ++i) {
        Mat3 sum = moments(adjacency, i, rest, skin.normals, rest, skin.normals);
        sum += 1e-3 * sum.trace() * Mat3::Identity();  // edges that lie on one line
        skin.surroundings[static_cast<std::size_t>(i)] = sum.inverse();
    }
}

Points follow(const SimulatedSkin& skin, const Adjacency& adjacency, const Points& scan,
              const Points& nodes) {
    Points result = scan;
    const Points& rest = skin.mesh.vertices;
    const int count = static_cast<int>(scan.cols());
    if (!skin.coarse()) {
        parallel_for(count, 4096, [&](int begin, int end) {
            for (int v = begin; v < end; ++v) {
                const int node = skin.between(0, v);
                if (node >= 0) {
                    result.col(v) += nodes.col(node) - rest.col(node);
                }
            }
        });
        return result;
    }
    const int n = skin.mesh.vertex_count();
    const Points normals = vertex_normals({nodes.leftCols(n), skin.mesh.triangles}, adjacency);
    std::vector<Mat3> motion(static_cast<std::size_t>(n));  // F − 1
    parallel_for(n, 512, [&](int begin, int end) {
        for (int i = begin; i < end; ++i) {
            Mat3& change = motion[static_cast<std::size_t>(i)];
            // (Σ e'eᵀ − Σ eeᵀ) S: exactly zero where nothing moved.
            change = (moments(adjacency, i, nodes, normals, rest, skin.normals) -
                      moments(adjacency, i, rest, skin.normals, rest, skin.normals)) *
                     skin.surroundings[static_cast<std::size_t>(i)];
            if (!(change.norm() < kStretchedMost)) {
                change.setZero();
            }
        }
    });
    parallel_for(count, 4096, [&](int begin, int end) {
        for (int v = begin; v < end; ++v) {
            if (skin.between(0, v) < 0) {
                continue;
            }
            Vec3 moved = Vec3::Zero();
            for (int k = 0; k < 3 && skin.between(k, v) >= 0; ++k) {
                const int node = skin.between(k, v);
                const Vec3 off = scan.col(v) - rest.col(node);
                moved += static_cast<double>(skin.shares(k, v)) *
                         (nodes.col(node) - rest.col(node) +
                          motion[static_cast<std::size_t>(node)] * off);
            }
            result.col(v) += moved;
        }
    });
    return result;
}

}  // namespace myoface
