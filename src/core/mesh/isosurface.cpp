// SPDX-License-Identifier: Apache-2.0
#include "myoface/mesh/isosurface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "myoface/base/parallel.h"

namespace myoface {
namespace {

constexpr int kBlock = 4;          // cells per block of the first, coarse look
constexpr double kSteepest = 1.6;  // the field may grow faster than a distance
constexpr float kNoField = 1e30F;

struct Grid {
    Vec3 origin;
    double cell = 1.0;
    Eigen::Vector3i points;  // per axis
    std::vector<float> values;

    std::size_t index(int i, int j, int k) const {
        return (static_cast<std::size_t>(k) * points[1] + j) * points[0] + i;
    }
    Vec3 at(int i, int j, int k) const { return origin + cell * Vec3(i, j, k); }
};

/// Samples the field near the surface only; everything else stays kNoField.
Grid sample(const ScalarField& field, const Eigen::AlignedBox3d& box, double cell) {
    Grid grid;
    grid.origin = box.min();
    grid.cell = cell;
    Eigen::Vector3i blocks;
    for (int axis = 0; axis < 3; ++axis) {
        blocks[axis] = static_cast<int>(std::ceil(box.sizes()[axis] / (cell * kBlock)));
        grid.points[axis] = blocks[axis] * kBlock + 1;
    }
    grid.values.assign(grid.index(0, 0, grid.points[2]), kNoField);
    const double reach = kSteepest * 0.5 * std::sqrt(3.0) * kBlock * cell;
    // A slab of blocks owns its lower planes; the last one owns its upper plane too.
    parallel_for(blocks[2], 1, [&](int begin, int end) {
        for (int bk = begin; bk < end; ++bk) {
            for (int bj = 0; bj < blocks[1]; ++bj) {
                for (int bi = 0; bi < blocks[0]; ++bi) {
                    const Vec3 centre = grid.at(bi * kBlock, bj * kBlock, bk * kBlock) +
                                        Vec3::Constant(0.5 * kBlock * cell);
                    if (std::abs(field(centre)) > reach + cell) {
                        continue;
                    }
                    const int last = bk + 1 == blocks[2] ? kBlock : kBlock - 1;
                    for (int k = bk * kBlock; k <= bk * kBlock + last; ++k) {
                        for (int j = bj * kBlock; j <= (bj + 1) * kBlock; ++j) {
                            for (int i = bi * kBlock; i <= (bi + 1) * kBlock; ++i) {
                                float& value = grid.values[grid.index(i, j, k)];
                                if (value == kNoField) {
                                    value = static_cast<float>(field(grid.at(i, j, k)));
                                }
                            }
                        }
                    }
                }
            }
        }
    });
    return grid;
}

class Marcher {
public:
    explicit Marcher(const Grid& grid) : grid_(grid) {}

    void tetrahedron(const std::array<Eigen::Vector3i, 4>& corners) {
        std::array<float, 4> values{};
        int inside = 0;
        for (int c = 0; c < 4; ++c) {
            values[c] = grid_.values[grid_.index(corners[c][0], corners[c][1], corners[c][2])];
            if (values[c] == kNoField) {
                return;
            }
            inside += values[c] < 0.0F ? 1 : 0;
        }
        if (inside == 0 || inside == 4) {
            return;
        }
        std::array<int, 4> order{};
        int low = 0;
        int high = 3;
        for (int c = 0; c < 4; ++c) {
            order[values[c] < 0.0F ? low++ : high--] = c;
        }
        const auto cut = [&](int a, int b) {
            return edge_vertex(corners[order[a]], values[order[a]], corners[order[b]],
                               values[order[b]]);
        };
        Vec3 outward = Vec3::Zero();
        for (int c = 0; c < 4; ++c) {
            outward +=
                (values[c] < 0.0F ? -1.0 / inside : 1.0 / (4 - inside)) * corners[c].cast<double>();
        }
        if (inside == 1) {
            add(cut(0, 1), cut(0, 2), cut(0, 3), outward);
        } else if (inside == 3) {
            add(cut(0, 3), cut(1, 3), cut(2, 3), outward);
        } else {
            const int a = cut(0, 2);
            const int b = cut(0, 3);
            const int c = cut(1, 3);
            const int d = cut(1, 2);
            add(a, b, c, outward);
            add(a, c, d, outward);
        }
    }

    TriangleMesh mesh() const {
        TriangleMesh result;
        result.vertices.resize(3, static_cast<Eigen::Index>(vertices_.size()));
        for (std::size_t v = 0; v < vertices_.size(); ++v) {
            result.vertices.col(static_cast<Eigen::Index>(v)) = vertices_[v];
        }
        result.triangles.resize(3, static_cast<Eigen::Index>(triangles_.size()));
        for (std::size_t t = 0; t < triangles_.size(); ++t) {
            result.triangles.col(static_cast<Eigen::Index>(t)) = triangles_[t];
        }
        return result;
    }

private:
    int edge_vertex(const Eigen::Vector3i& a, float value_a, const Eigen::Vector3i& b,
                    float value_b) {
        std::uint64_t p = grid_.index(a[0], a[1], a[2]);
        std::uint64_t q = grid_.index(b[0], b[1], b[2]);
        if (p > q) {
            std::swap(p, q);
        }
        const auto [found, fresh] = on_edge_.try_emplace((p << 32) | q, vertices_.size());
        if (fresh) {
            // Not too close to a grid point: the triangle there would have no area.
            const double share =
                std::clamp(static_cast<double>(value_a) / (value_a - value_b), 0.02, 0.98);
            vertices_.push_back(grid_.origin + grid_.cell * ((1.0 - share) * a.cast<double>() +
                                                             share * b.cast<double>()));
        }
        return static_cast<int>(found->second);
    }

    void add(int a, int b, int c, const Vec3& outward) {
        const Vec3 normal = (vertices_[b] - vertices_[a]).cross(vertices_[c] - vertices_[a]);
        if (normal.dot(outward) < 0.0) {
            std::swap(b, c);
        }
        triangles_.emplace_back(a, b, c);
    }

    const Grid& grid_;
    std::unordered_map<std::uint64_t, std::size_t> on_edge_;
    std::vector<Vec3> vertices_;
    std::vector<Eigen::Vector3i> triangles_;
};

}  // namespace

TriangleMesh isosurface(const ScalarField& field, const Eigen::AlignedBox3d& box, double cell) {
    const Grid grid = sample(field, box, cell);
    Marcher marcher(grid);
    // The six tetrahedra around the diagonal of a cube: a path of three unit steps each.
    static constexpr std::array<std::array<int, 3>, 6> kPaths{
        {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}}};
    for (int k = 0; k + 1 < grid.points[2]; ++k) {
        for (int j = 0; j + 1 < grid.points[1]; ++j) {
            for (int i = 0; i + 1 < grid.points[0]; ++i) {
                if (grid.values[grid.index(i, j, k)] == kNoField) {
                    continue;
                }
                for (const auto& path : kPaths) {
                    std::array<Eigen::Vector3i, 4> corners;
                    corners[0] = {i, j, k};
                    for (int step = 0; step < 3; ++step) {
                        corners[step + 1] = corners[step];
                        ++corners[step + 1][path[step]];
                    }
                    marcher.tetrahedron(corners);
                }
            }
        }
    }
    return marcher.mesh();
}

}  // namespace myoface
