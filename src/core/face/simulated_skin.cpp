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

namespace {

/// (Σ e'eᵀ − Σ eeᵀ) S: exactly zero where nothing moved.
Mat3 affine_change(const SimulatedSkin& skin, const Adjacency& adjacency, int node,
                   const Points& nodes, const Points& normals) {
    const Points& rest = skin.mesh.vertices;
    Mat3 change = (moments(adjacency, node, nodes, normals, rest, skin.normals) -
                   moments(adjacency, node, rest, skin.normals, rest, skin.normals)) *
                  skin.surroundings[static_cast<std::size_t>(node)];
    if (!(change.norm() < kStretchedMost)) {
        change.setZero();
    }
    return change;
}

/// How far a vertex goes with its nodes.
Vec3 followed(const SimulatedSkin& skin, int v, const Vec3& at, const Points& nodes,
              const std::vector<Mat3>& motion) {
    Vec3 moved = Vec3::Zero();
    for (int k = 0; k < 3 && skin.between(k, v) >= 0; ++k) {
        const int node = skin.between(k, v);
        const Vec3 rest = skin.mesh.vertices.col(node);
        moved += static_cast<double>(skin.shares(k, v)) *
                 (nodes.col(node) - rest + motion[static_cast<std::size_t>(node)] * (at - rest));
    }
    return moved;
}

}  // namespace

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
    std::vector<Mat3> motion(static_cast<std::size_t>(n));
    parallel_for(n, 512, [&](int begin, int end) {
        for (int i = begin; i < end; ++i) {
            motion[static_cast<std::size_t>(i)] = affine_change(skin, adjacency, i, nodes, normals);
        }
    });
    parallel_for(count, 4096, [&](int begin, int end) {
        for (int v = begin; v < end; ++v) {
            if (skin.between(0, v) >= 0) {
                result.col(v) += followed(skin, v, scan.col(v), nodes, motion);
            }
        }
    });
    return result;
}

FollowingScan::FollowingScan(const SimulatedSkin& skin, const Adjacency& adjacency,
                             const Points& scan, const Eigen::Matrix3Xf& normals)
    : skin_(skin),
      adjacency_(adjacency),
      scan_(scan),
      vertices_(scan),
      rest_normals_(skin.coarse() ? normals : Eigen::Matrix3Xf(3, 0)),
      normals_(rest_normals_),
      nodes_(skin.mesh.vertices),
      motion_(static_cast<std::size_t>(skin.coarse() ? nodes_.cols() : 0), Mat3::Zero()),
      touched_(static_cast<std::size_t>(scan.cols()), 0) {}

const Points& FollowingScan::follow(const Points& nodes) {
    constexpr double kUnseen = 0.01;  // [mm]
    const auto n = static_cast<int>(nodes_.cols());
    moved_.assign(static_cast<std::size_t>(n), 0);
    parallel_for(n, 2048, [&](int begin, int end) {
        for (int i = begin; i < end; ++i) {
            if ((nodes.col(i) - nodes_.col(i)).cwiseAbs().maxCoeff() > kUnseen) {
                moved_[static_cast<std::size_t>(i)] = 1;
                nodes_.col(i) = nodes.col(i);
            }
        }
    });
    stale_ = moved_;
    if (skin_.coarse()) {
        // A vertex goes with the affine motion of its nodes, that with all of their neighbours.
        const Points normals = vertex_normals({nodes_, skin_.mesh.triangles}, adjacency_);
        parallel_for(n, 512, [&](int begin, int end) {
            for (int i = begin; i < end; ++i) {
                bool stale = moved_[static_cast<std::size_t>(i)] != 0;
                for (const int j : adjacency_.neighbours(i)) {
                    stale = stale || moved_[static_cast<std::size_t>(j)] != 0;
                }
                if (stale) {
                    stale_[static_cast<std::size_t>(i)] = 1;
                    motion_[static_cast<std::size_t>(i)] =
                        affine_change(skin_, adjacency_, i, nodes_, normals);
                }
            }
        });
    }
    parallel_for(static_cast<int>(scan_.cols()), 4096, [&](int begin, int end) {
        for (int v = begin; v < end; ++v) {
            bool touched = false;
            for (int k = 0; k < 3 && skin_.between(k, v) >= 0; ++k) {
                touched = touched || stale_[static_cast<std::size_t>(skin_.between(k, v))] != 0;
            }
            touched_[static_cast<std::size_t>(v)] = touched ? 1 : 0;
            if (touched) {
                follow_vertex(v);
            }
        }
    });
    return vertices_;
}

void FollowingScan::follow_vertex(int v) {
    if (skin_.coarse()) {
        vertices_.col(v) = scan_.col(v) + followed(skin_, v, scan_.col(v), nodes_, motion_);
        Mat3 f = Mat3::Identity();
        for (int k = 0; k < 3 && skin_.between(k, v) >= 0; ++k) {
            f += static_cast<double>(skin_.shares(k, v)) *
                 motion_[static_cast<std::size_t>(skin_.between(k, v))];
        }
        // Normals turn with the cofactors: with the areas that they stand on.
        const Vec3 normal = rest_normals_.col(v).cast<double>();
        const Vec3 turned = normal.x() * f.col(1).cross(f.col(2)) +
                            normal.y() * f.col(2).cross(f.col(0)) +
                            normal.z() * f.col(0).cross(f.col(1));
        const double length = turned.norm();
        if (length > 1e-6) {
            normals_.col(v) = (turned / length).cast<float>();
        }
        return;
    }
    const int node = skin_.between(0, v);
    vertices_.col(v) = scan_.col(v) + nodes_.col(node) - skin_.mesh.vertices.col(node);
}

}  // namespace myoface
