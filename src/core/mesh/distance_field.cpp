// SPDX-License-Identifier: Apache-2.0
#include "myoface/mesh/distance_field.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "myoface/mesh/adjacency.h"
#include "myoface/mesh/normals.h"

namespace myoface {
namespace {

constexpr double kAround = 6.0;  // lattice beyond the surface's box [mm]

}  // namespace

DistanceField::DistanceField(TriangleMesh surface, double cell)
    : surface_(std::move(surface)),
      bvh_(surface_),
      normals_(vertex_normals(surface_, Adjacency(surface_))),
      cell_(cell),
      box_(surface_.vertices.rowwise().minCoeff(), surface_.vertices.rowwise().maxCoeff()) {
    box_.min().array() -= kAround;
    box_.max().array() += kAround;
    // One more than the box needs: its last point may be nearest to a lattice point beyond.
    const Eigen::Array3d points = box_.sizes().array() / cell_ + 1.0;
    blocks_ = (points / kSide).ceil().cast<int>();
    filled_ = std::vector<std::atomic<const Block*>>(static_cast<std::size_t>(blocks_.prod()));
}

DistanceField::~DistanceField() {
    for (const std::atomic<const Block*>& block : filled_) {
        delete block.load();
    }
}

double DistanceField::exact(const Vec3& p) const {
    return exact(p, std::numeric_limits<double>::infinity());
}

double DistanceField::exact(const Vec3& p, double within) const {
    const ClosestPoint found = bvh_.closest_point(surface_, p, within);
    const auto corners = surface_.triangles.col(found.where.triangle);
    // Across an edge the face's own normal may look the other way.
    Vec3 normal = Vec3::Zero();
    for (int c = 0; c < 3; ++c) {
        normal += found.where.weights[c] * normals_.col(corners[c]);
    }
    return (p - found.point).dot(normal) < 0.0 ? -found.distance : found.distance;
}

const DistanceField::Block& DistanceField::block(const Eigen::Vector3i& which) const {
    const int index = which.x() + blocks_.x() * (which.y() + blocks_.y() * which.z());
    std::atomic<const Block*>& place = filled_[static_cast<std::size_t>(index)];
    if (const Block* ready = place.load(std::memory_order_acquire)) {
        return *ready;
    }
    auto fresh = std::make_unique<Block>();
    std::size_t corner = 0;
    Vec3 last = Vec3::Zero();
    double within = std::numeric_limits<double>::infinity();
    for (int z = -1; z <= kSide; ++z) {
        for (int y = -1; y <= kSide; ++y) {
            for (int x = -1; x <= kSide; ++x) {
                const Eigen::Vector3i lattice = kSide * which + Eigen::Vector3i(x, y, z);
                const Vec3 p = box_.min() + cell_ * lattice.cast<double>();
                // No further than from the corner before it and the way from there.
                const double distance = exact(p, within + 1.001 * (p - last).norm());
                (*fresh)[corner++] = static_cast<float>(distance);
                within = std::abs(distance) + 1e-6;
                last = p;
            }
        }
    }
    const Block* nobody = nullptr;
    if (place.compare_exchange_strong(nobody, fresh.get(), std::memory_order_acq_rel)) {
        return *fresh.release();
    }
    return *nobody;  // another thread was quicker, with the same numbers
}

DistanceField::Sample DistanceField::at(const Vec3& p) const {
    if (!box_.contains(p)) {
        // The surface is at least as far as the box without its margin.
        return {box_.exteriorDistance(p) + kAround, Vec3::Zero()};
    }
    const Vec3 place = (p - box_.min()) / cell_;
    Eigen::Vector3i which;
    Eigen::Vector3i first;      // of the three points a spline reaches over, within the block
    std::array<Vec3, 3> share;  // of each of them, per axis
    std::array<Vec3, 3> rise;
    for (int axis = 0; axis < 3; ++axis) {
        const int nearest = static_cast<int>(place[axis] + 0.5);
        which[axis] = nearest / kSide;
        first[axis] = nearest % kSide;
        const double t = place[axis] - nearest;  // −½ … ½
        share[0][axis] = 0.5 * (0.5 - t) * (0.5 - t);
        share[1][axis] = 0.75 - t * t;
        share[2][axis] = 0.5 * (0.5 + t) * (0.5 + t);
        rise[0][axis] = t - 0.5;
        rise[1][axis] = -2.0 * t;
        rise[2][axis] = t + 0.5;
    }
    const Block& values = block(which);
    Sample sample;
    for (std::size_t z = 0; z < 3; ++z) {
        Vec3 plane = Vec3::Zero();  // the value in it, and its slopes along x and y
        for (std::size_t y = 0; y < 3; ++y) {
            const float* row = &values[static_cast<std::size_t>(first.x()) +
                                       kRow * (static_cast<std::size_t>(first.y()) + y +
                                               kRow * (static_cast<std::size_t>(first.z()) + z))];
            double along = 0.0;
            double steep = 0.0;
            for (std::size_t x = 0; x < 3; ++x) {
                const auto value = static_cast<double>(row[x]);
                along += share[x].x() * value;
                steep += rise[x].x() * value;
            }
            plane += Vec3(share[y].y() * along, share[y].y() * steep, rise[y].y() * along);
        }
        sample.distance += share[z].z() * plane[0];
        sample.slope +=
            Vec3(share[z].z() * plane[1], share[z].z() * plane[2], rise[z].z() * plane[0]);
    }
    sample.slope /= cell_;
    return sample;
}

}  // namespace myoface
