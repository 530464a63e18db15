// SPDX-License-Identifier: Apache-2.0
#include "myoface/mesh/distance_field.h"

#include <algorithm>
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
    blocks_ = (box_.sizes() / (cell_ * kSide)).array().ceil().cast<int>();
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
    for (int z = 0; z <= kSide; ++z) {
        for (int y = 0; y <= kSide; ++y) {
            for (int x = 0; x <= kSide; ++x) {
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
    Eigen::Vector3i cell;
    Vec3 share;
    for (int axis = 0; axis < 3; ++axis) {
        const int lattice = std::min(static_cast<int>(place[axis]), blocks_[axis] * kSide - 1);
        which[axis] = lattice / kSide;
        cell[axis] = lattice % kSide;
        share[axis] = place[axis] - lattice;
    }
    const Block& values = block(which);
    constexpr int kRow = kSide + 1;
    const int first = cell.x() + kRow * (cell.y() + kRow * cell.z());
    const auto value = [&](int x, int y, int z) {
        return static_cast<double>(
            values[static_cast<std::size_t>(first + x + kRow * (y + kRow * z))]);
    };
    // Along x, then y, then z; the slopes by the same steps.
    double along[2][2];
    double rise[2][2];
    for (int z = 0; z < 2; ++z) {
        for (int y = 0; y < 2; ++y) {
            rise[z][y] = value(1, y, z) - value(0, y, z);
            along[z][y] = value(0, y, z) + share.x() * rise[z][y];
        }
    }
    const auto mix = [](double a, double b, double t) { return a + t * (b - a); };
    const double low = mix(along[0][0], along[0][1], share.y());
    const double high = mix(along[1][0], along[1][1], share.y());
    Sample sample;
    sample.distance = mix(low, high, share.z());
    sample.slope.x() = mix(mix(rise[0][0], rise[0][1], share.y()),
                           mix(rise[1][0], rise[1][1], share.y()), share.z());
    sample.slope.y() = mix(along[0][1] - along[0][0], along[1][1] - along[1][0], share.z());
    sample.slope.z() = high - low;
    sample.slope /= cell_;
    return sample;
}

}  // namespace myoface
