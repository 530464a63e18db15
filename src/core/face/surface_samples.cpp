// SPDX-License-Identifier: Apache-2.0
#include "surface_samples.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "myoface/base/parallel.h"

namespace myoface {

SurfaceSamples sample_surface(const TriangleMesh& mesh, int count) {
    const int triangles = mesh.triangle_count();
    double total = 0.0;
    for (int t = 0; t < triangles; ++t) {
        total += double_area_vector(mesh, t).norm();
    }
    SurfaceSamples samples;
    samples.points.resize(3, count);
    samples.normals.resize(3, count);
    const double step = total / count;
    samples.area = 0.5 * step;
    double next = 0.5 * step;
    double passed = 0.0;
    int n = 0;
    for (int t = 0; t < triangles && n < count; ++t) {
        const Vec3 area = double_area_vector(mesh, t);
        const double size = area.norm();
        passed += size;
        for (; next < passed && n < count; next += step, ++n) {
            // Two irrational steps fill any run of triangles evenly.
            double u = std::fmod(0.7548776662466927 * n, 1.0);
            double v = std::fmod(0.5698402909980532 * n, 1.0);
            if (u + v > 1.0) {
                u = 1.0 - u;
                v = 1.0 - v;
            }
            samples.points.col(n) =
                (1.0 - u - v) * mesh.corner(t, 0) + u * mesh.corner(t, 1) + v * mesh.corner(t, 2);
            samples.normals.col(n) = area / size;
        }
    }
    samples.points.conservativeResize(3, n);
    samples.normals.conservativeResize(3, n);
    return samples;
}

Eigen::VectorXd relief(const SurfaceSamples& samples, double reach) {
    const Eigen::Index n = samples.points.cols();
    Eigen::VectorXd result = Eigen::VectorXd::Zero(n);
    if (n == 0) {
        return result;
    }
    // Samples sorted by cell; three cells along x are one run.
    const Vec3 low = samples.points.rowwise().minCoeff();
    const auto key = [](const Eigen::Array3d& at) {
        const auto part = [](double x) {
            return static_cast<std::uint64_t>(std::clamp(x + 1.0, 0.0, 1e6));
        };
        return part(at.x()) | part(at.y()) << 20 | part(at.z()) << 40;
    };
    const auto cell = [&](Eigen::Index i) -> Eigen::Array3d {
        return ((samples.points.col(i) - low) / reach).array().floor();
    };
    // About sixty neighbours tell as much as all.
    constexpr double kNeighbours = 60.0;
    const double all = std::numbers::pi * reach * reach / std::max(samples.area, 1e-12);
    const auto stride =
        std::clamp<Eigen::Index>(static_cast<Eigen::Index>(all / kNeighbours), 1, 64);
    std::vector<std::pair<std::uint64_t, int>> cells;
    for (Eigen::Index i = 0; i < n; i += stride) {
        cells.emplace_back(key(cell(i)), static_cast<int>(i));
    }
    std::sort(cells.begin(), cells.end());
    parallel_for(static_cast<int>(n), 256, [&](int begin, int end) {
        for (int i = begin; i < end; ++i) {
            const Vec3 p = samples.points.col(i);
            const Vec3 own = samples.normals.col(i);
            const Eigen::Array3d at = cell(i);
            Vec3 normal = Vec3::Zero();
            Vec3 middle = Vec3::Zero();
            double count = 0.0;
            for (int dz = -1; dz <= 1; ++dz) {
                for (int dy = -1; dy <= 1; ++dy) {
                    const std::uint64_t first = key(at + Eigen::Array3d(-1, dy, dz));
                    auto entry = std::lower_bound(cells.begin(), cells.end(), std::pair(first, -1));
                    for (; entry != cells.end() && entry->first <= first + 2; ++entry) {
                        const int k = entry->second;
                        // The other side of a thin sheet does not count.
                        if ((samples.points.col(k) - p).squaredNorm() < reach * reach &&
                            own.dot(samples.normals.col(k)) > 0.0) {
                            normal += samples.normals.col(k);
                            middle += samples.points.col(k);
                            count += 1.0;
                        }
                    }
                }
            }
            if (count > 0.0) {
                result[i] = normal.normalized().dot(p - middle / count);
            }
        }
    });
    return result;
}

NearestTable::NearestTable(const Points& points, double cell, int reach) {
    constexpr double kMostCells = 3e6;
    const Vec3 low = points.rowwise().minCoeff();
    const Vec3 extent = points.rowwise().maxCoeff() - low;
    cell_ = cell;
    while (((extent / cell_).array() + (2.0 * reach + 1.0)).prod() > kMostCells) {
        cell_ *= 1.15;
    }
    low_ = low.array() - reach * cell_;
    size_ = ((extent / cell_).array() + (2.0 * reach + 1.0)).cast<int>();
    cells_.assign(static_cast<std::size_t>(size_.prod()), -1);
    const auto centre = [&](const Eigen::Array3i& at) -> Vec3 {
        return low_ + cell_ * (at.cast<double>() + 0.5).matrix();
    };
    std::vector<Eigen::Array3i> front;
    for (Eigen::Index i = 0; i < points.cols(); ++i) {
        const Eigen::Array3i at = ((points.col(i) - low_).array() / cell_).cast<int>();
        int& here = cells_[index(at)];
        if (here < 0) {
            here = static_cast<int>(i);
            front.push_back(at);
        } else if ((points.col(i) - centre(at)).squaredNorm() <
                   (points.col(here) - centre(at)).squaredNorm()) {
            here = static_cast<int>(i);
        }
    }
    // Outwards cell by cell; a cell takes the nearest of what its reached neighbours know.
    for (int layer = 0; layer < reach; ++layer) {
        std::vector<Eigen::Array3i> next;
        for (const Eigen::Array3i& at : front) {
            for (int side = 0; side < 6; ++side) {
                Eigen::Array3i to = at;
                to[side / 2] += side % 2 == 0 ? 1 : -1;
                if ((to < 0).any() || (to >= size_).any()) {
                    continue;
                }
                int& there = cells_[index(to)];
                const int known = cells_[index(at)];
                if (there < 0) {
                    there = known;
                    next.push_back(to);
                } else if ((points.col(known) - centre(to)).squaredNorm() <
                           (points.col(there) - centre(to)).squaredNorm()) {
                    there = known;
                }
            }
        }
        front = std::move(next);
    }
}

}  // namespace myoface
