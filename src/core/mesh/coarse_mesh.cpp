// SPDX-License-Identifier: Apache-2.0
#include "myoface/mesh/coarse_mesh.h"

#include <algorithm>
#include <array>
#include <functional>
#include <limits>
#include <span>

#include "myoface/base/parallel.h"
#include "myoface/mesh/bvh.h"
#include "myoface/mesh/vertex_triangles.h"

namespace myoface {
namespace {

/// An edge at the vertex has one triangle only.
bool on_border(const TriangleMesh& mesh, std::span<const int> triangles, int vertex) {
    for (const int t : triangles) {
        for (int c = 0; c < 3; ++c) {
            const int w = mesh.triangles(c, t);
            if (w == vertex) {
                continue;
            }
            int shared = 0;
            for (const int other : triangles) {
                shared += (mesh.triangles.col(other).array() == w).any() ? 1 : 0;
            }
            if (shared == 1) {
                return true;
            }
        }
    }
    return false;
}

/// Which spread vertex is the nearest along the edges.
struct Cells {
    std::vector<int> owner;       ///< per vertex
    std::vector<float> distance;  ///< [mm]
};

class Spreading {
public:
    Spreading(const TriangleMesh& mesh, const VertexTriangles& corners,
              const Eigen::VectorXf& spacing)
        : mesh_(mesh), corners_(corners), spacing_(spacing) {
        const auto n = static_cast<std::size_t>(mesh.vertex_count());
        cells_.owner.assign(n, -1);
        cells_.distance.assign(n, std::numeric_limits<float>::max());
    }

    Cells run(const std::vector<int>& kept) {
        const auto n = mesh_.vertex_count();
        for (const int v : kept) {
            if (cells_.owner[static_cast<std::size_t>(v)] != v) {
                add(v);
            }
        }
        std::vector<char> border(static_cast<std::size_t>(n), 0);
        parallel_for(n, 4096, [&](int begin, int end) {
            for (int v = begin; v < end; ++v) {
                border[static_cast<std::size_t>(v)] = on_border(mesh_, corners_.at(v), v) ? 1 : 0;
            }
        });
        for (const char now : {1, 0}) {
            for (int v = 0; v < n; ++v) {
                const auto i = static_cast<std::size_t>(v);
                if (border[i] == now && cells_.distance[i] > spacing_[v]) {
                    add(v);
                }
            }
        }
        return std::move(cells_);
    }

private:
    /// Takes what is nearer to this vertex than to any before, as far as its reach goes.
    void add(int seed) {
        constexpr float kReach = 1.6F;  // of the spacing: the spacing of its surroundings differs
        const float reach = kReach * spacing_[seed];
        queue_.emplace_back(0.0F, seed);
        take(seed, seed, 0.0F);
        while (!queue_.empty()) {
            std::pop_heap(queue_.begin(), queue_.end(), std::greater<>());
            const auto [distance, v] = queue_.back();
            queue_.pop_back();
            if (distance > cells_.distance[static_cast<std::size_t>(v)]) {
                continue;
            }
            const Vec3 at = mesh_.vertices.col(v);
            for (const int t : corners_.at(v)) {
                for (int c = 0; c < 3; ++c) {
                    const int w = mesh_.triangles(c, t);
                    if (w == v) {
                        continue;
                    }
                    const float there =
                        distance + static_cast<float>((mesh_.vertices.col(w) - at).norm());
                    if (there < cells_.distance[static_cast<std::size_t>(w)] && there <= reach) {
                        take(w, seed, there);
                        queue_.emplace_back(there, w);
                        std::push_heap(queue_.begin(), queue_.end(), std::greater<>());
                    }
                }
            }
        }
    }

    void take(int vertex, int seed, float distance) {
        cells_.owner[static_cast<std::size_t>(vertex)] = seed;
        cells_.distance[static_cast<std::size_t>(vertex)] = distance;
    }

    const TriangleMesh& mesh_;
    const VertexTriangles& corners_;
    const Eigen::VectorXf& spacing_;
    Cells cells_;
    std::vector<std::pair<float, int>> queue_;
};

/// A triangle wherever three cells meet. One that appears with both senses is a pinch, not a face.
Triangles dual_triangles(const TriangleMesh& mesh, const std::vector<int>& cell) {
    std::vector<std::array<int, 3>> found;
    for (int t = 0; t < mesh.triangle_count(); ++t) {
        std::array<int, 3> at{};
        for (int c = 0; c < 3; ++c) {
            at[static_cast<std::size_t>(c)] = cell[static_cast<std::size_t>(mesh.triangles(c, t))];
        }
        if (at[0] != at[1] && at[1] != at[2] && at[2] != at[0]) {
            std::rotate(at.begin(), std::min_element(at.begin(), at.end()), at.end());
            found.push_back(at);
        }
    }
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    std::vector<std::array<int, 3>> faces;
    for (const auto& face : found) {
        if (!std::binary_search(found.begin(), found.end(),
                                std::array<int, 3>{face[0], face[2], face[1]})) {
            faces.push_back(face);
        }
    }
    Triangles triangles(3, static_cast<Eigen::Index>(faces.size()));
    for (std::size_t t = 0; t < faces.size(); ++t) {
        triangles.col(static_cast<Eigen::Index>(t)) << faces[t][0], faces[t][1], faces[t][2];
    }
    return triangles;
}

}  // namespace

CoarseMesh coarsen(const TriangleMesh& mesh, const Eigen::VectorXf& spacing,
                   const std::vector<int>& kept) {
    const int n = mesh.vertex_count();
    const VertexTriangles corners(mesh);
    const Cells cells = Spreading(mesh, corners, spacing).run(kept);

    CoarseMesh coarse;
    std::vector<int> number(static_cast<std::size_t>(n), -1);
    for (int v = 0; v < n; ++v) {
        if (cells.owner[static_cast<std::size_t>(v)] == v) {
            number[static_cast<std::size_t>(v)] = static_cast<int>(coarse.fine.size());
            coarse.fine.push_back(v);
        }
    }
    std::vector<int> cell(static_cast<std::size_t>(n));
    for (std::size_t v = 0; v < cell.size(); ++v) {
        cell[v] = number[static_cast<std::size_t>(cells.owner[v])];
    }
    coarse.mesh.vertices.resize(3, static_cast<Eigen::Index>(coarse.fine.size()));
    for (std::size_t k = 0; k < coarse.fine.size(); ++k) {
        coarse.mesh.vertices.col(static_cast<Eigen::Index>(k)) = mesh.vertices.col(coarse.fine[k]);
    }
    coarse.mesh.triangles = dual_triangles(mesh, cell);

    coarse.between.resize(3, n);
    coarse.shares.resize(3, n);
    const VertexTriangles around(coarse.mesh);
    parallel_for(n, 1024, [&](int begin, int end) {
        for (int v = begin; v < end; ++v) {
            const int own = cell[static_cast<std::size_t>(v)];
            coarse.between.col(v) << own, -1, -1;
            coarse.shares.col(v) << 1.0F, 0.0F, 0.0F;
            if (coarse.fine[static_cast<std::size_t>(own)] == v) {
                continue;
            }
            const Vec3 p = mesh.vertices.col(v);
            double nearest = std::numeric_limits<double>::max();
            for (const int t : around.at(own)) {
                const Vec3 a = coarse.mesh.corner(t, 0);
                const Vec3 b = coarse.mesh.corner(t, 1);
                const Vec3 c = coarse.mesh.corner(t, 2);
                const Vec3 w = closest_barycentric(a, b, c, p);
                const double off = (w[0] * a + w[1] * b + w[2] * c - p).squaredNorm();
                if (off < nearest) {
                    nearest = off;
                    coarse.between.col(v) = coarse.mesh.triangles.col(t);
                    coarse.shares.col(v) = w.cast<float>();
                }
            }
        }
    });
    return coarse;
}

}  // namespace myoface
