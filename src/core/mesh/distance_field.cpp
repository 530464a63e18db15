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
    // A point of the box has neighbours of its nearest lattice point on both sides: the lattice
    // begins one before the box and ends one or two behind it.
    points_ = (box_.sizes() / cell_).array().floor().cast<int>() + 4;
    values_ = std::vector<std::atomic<float>>(
        static_cast<std::size_t>(points_.cast<Eigen::Index>().prod()));
    for (std::atomic<float>& value : values_) {
        value.store(std::numeric_limits<float>::quiet_NaN(), std::memory_order_relaxed);
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

std::size_t DistanceField::index(const Eigen::Vector3i& lattice) const {
    const Eigen::Matrix<std::size_t, 3, 1> at = (lattice.array() + 1).cast<std::size_t>();
    const Eigen::Matrix<std::size_t, 3, 1> row = points_.cast<std::size_t>();
    return at.x() + row.x() * (at.y() + row.y() * at.z());
}

/// What is not known yet of a lattice point and its 26 neighbours.
void DistanceField::find_around(const Eigen::Vector3i& nearest) const {
    Vec3 last = Vec3::Zero();
    double within = std::numeric_limits<double>::infinity();
    for (int z = -1; z <= 1; ++z) {
        for (int y = -1; y <= 1; ++y) {
            for (int x = -1; x <= 1; ++x) {
                const Eigen::Vector3i lattice = nearest + Eigen::Vector3i(x, y, z);
                const Vec3 p = box_.min() + cell_ * lattice.cast<double>();
                std::atomic<float>& value = values_[index(lattice)];
                auto distance = static_cast<double>(value.load(std::memory_order_relaxed));
                if (std::isnan(distance)) {
                    // No further than from the point before it and the way from there.
                    distance = exact(p, within + 1.001 * (p - last).norm());
                    value.store(static_cast<float>(distance), std::memory_order_relaxed);
                }
                within = std::abs(distance) * (1.0 + 1e-6) + 1e-6;  // it was rounded
                last = p;
            }
        }
    }
}

DistanceField::Sample DistanceField::at(const Vec3& p) const {
    if (!box_.contains(p)) {
        // The surface is at least as far as the box without its margin.
        return {box_.exteriorDistance(p) + kAround, Vec3::Zero()};
    }
    const Vec3 place = (p - box_.min()) / cell_;
    Eigen::Vector3i nearest;    // of the three points a spline reaches over, the middle one
    std::array<Vec3, 3> share;  // of each of them, per axis
    std::array<Vec3, 3> rise;
    for (int axis = 0; axis < 3; ++axis) {
        nearest[axis] = static_cast<int>(place[axis] + 0.5);
        const double t = place[axis] - nearest[axis];  // −½ … ½
        share[0][axis] = 0.5 * (0.5 - t) * (0.5 - t);
        share[1][axis] = 0.75 - t * t;
        share[2][axis] = 0.5 * (0.5 + t) * (0.5 + t);
        rise[0][axis] = t - 0.5;
        rise[1][axis] = -2.0 * t;
        rise[2][axis] = t + 0.5;
    }
    const std::size_t first = index(nearest.array() - 1);
    const auto row = static_cast<std::size_t>(points_.x());
    const std::size_t layer = row * static_cast<std::size_t>(points_.y());
    const auto interpolated = [&] {
        Sample sample;
        for (std::size_t z = 0; z < 3; ++z) {
            Vec3 plane = Vec3::Zero();  // the value in it, and its slopes along x and y
            for (std::size_t y = 0; y < 3; ++y) {
                const std::atomic<float>* values = &values_[first + y * row + z * layer];
                double along = 0.0;
                double steep = 0.0;
                for (std::size_t x = 0; x < 3; ++x) {
                    const auto value =
                        static_cast<double>(values[x].load(std::memory_order_relaxed));
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
    };
    Sample sample = interpolated();
    if (std::isnan(sample.distance)) {  // as long as one of the values is missing
        find_around(nearest);
        sample = interpolated();
    }
    return sample;
}

}  // namespace myoface
