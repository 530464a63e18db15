// SPDX-License-Identifier: Apache-2.0
#include "myoface/mesh/remesh.h"

#include <algorithm>
#include <array>
#include <tuple>
#include <vector>

#include <queue>

#include "myoface/base/parallel.h"
#include "myoface/mesh/adjacency.h"

namespace myoface {
namespace {

constexpr double kSplit = 1.36;     // × wanted length
constexpr double kCollapse = 0.72;  // × wanted length

/// A mesh that can change: triangles per vertex, dead items marked and left in place.
class Surface {
public:
    Surface(const TriangleMesh& mesh, const RemeshOptions& options) : options_(options) {
        for (int v = 0; v < mesh.vertex_count(); ++v) {
            add_vertex(mesh.vertices.col(v),
                       options.lines.empty() ? kFreeVertex : options.lines[v]);
        }
        for (int t = 0; t < mesh.triangle_count(); ++t) {
            add_triangle({mesh.triangles(0, t), mesh.triangles(1, t), mesh.triangles(2, t)});
        }
        const Adjacency adjacency(mesh);
        for (const MeshEdge& edge : adjacency.edges()) {
            if (edge.triangle_count == 1 && options.lines.empty()) {
                line_[edge.vertices[0]] = line_[edge.vertices[1]] = 1;
            }
        }
    }

    /// Longest first: then no split makes an edge longer than the one it divides, and it ends.
    void split_long_edges() {
        using Entry = std::tuple<double, int, int>;  // length over the wanted one, ends
        std::priority_queue<Entry> longest;
        const auto offer = [&](int a, int b) {
            const double ratio = length(a, b) / wanted(a, b);
            if (ratio > kSplit) {
                longest.emplace(ratio, std::min(a, b), std::max(a, b));
            }
        };
        for (std::size_t t = 0; t < triangles_.size(); ++t) {
            for (int c = 0; c < 3 && alive(t); ++c) {
                offer(triangles_[t][c], triangles_[t][(c + 1) % 3]);
            }
        }
        while (!longest.empty()) {
            const auto [ratio, a, b] = longest.top();
            longest.pop();
            if (sharing(a, b).empty()) {
                continue;  // offered by both its triangles, split already
            }
            const int middle = split(a, b);
            for (const int w : ring(middle)) {
                offer(middle, w);
            }
        }
    }

    void collapse_short_edges() {
        for (std::size_t t = 0; t < triangles_.size(); ++t) {
            for (int c = 0; c < 3 && alive(t); ++c) {
                const int a = triangles_[t][c];
                const int b = triangles_[t][(c + 1) % 3];
                if (length(a, b) < kCollapse * wanted(a, b)) {
                    if (!collapse(a, b)) {
                        collapse(b, a);
                    }
                }
            }
        }
    }

    /// Delaunay: the diagonal whose opposite angles sum to less.
    void flip_edges() {
        for (std::size_t t = 0; t < triangles_.size(); ++t) {
            for (int c = 0; c < 3 && alive(t); ++c) {
                flip_if_better(triangles_[t][c], triangles_[t][(c + 1) % 3]);
            }
        }
    }

    void relax(bool project) {
        const int n = static_cast<int>(positions_.size());
        std::vector<Vec3> next = positions_;
        parallel_for(n, 512, [&](int begin, int end) {
            for (int v = begin; v < end; ++v) {
                next[v] = relaxed(v, project);
            }
        });
        positions_.swap(next);
        parallel_for(n, 512, [&](int begin, int end) {
            for (int v = begin; v < end; ++v) {
                wanted_[v] = options_.edge_length(positions_[v]);
            }
        });
    }

    RemeshedSurface surface() const {
        RemeshedSurface surface;
        TriangleMesh& result = surface.mesh;
        std::vector<int> number(positions_.size(), -1);
        std::vector<Eigen::Vector3i> kept;
        for (std::size_t t = 0; t < triangles_.size(); ++t) {
            if (alive(t)) {
                kept.emplace_back(triangles_[t][0], triangles_[t][1], triangles_[t][2]);
                for (const int v : triangles_[t]) {
                    number[v] = 0;
                }
            }
        }
        int count = 0;
        for (int& n : number) {
            n = n == 0 ? count++ : -1;
        }
        result.vertices.resize(3, count);
        surface.lines.resize(static_cast<std::size_t>(count));
        for (std::size_t v = 0; v < number.size(); ++v) {
            if (number[v] >= 0) {
                result.vertices.col(number[v]) = positions_[v];
                surface.lines[number[v]] = line_[v];
            }
        }
        result.triangles.resize(3, static_cast<Eigen::Index>(kept.size()));
        for (std::size_t t = 0; t < kept.size(); ++t) {
            for (int c = 0; c < 3; ++c) {
                result.triangles(c, static_cast<Eigen::Index>(t)) = number[kept[t][c]];
            }
        }
        return surface;
    }

private:
    using Corners = std::array<int, 3>;

    bool alive(std::size_t t) const { return triangles_[t][0] >= 0; }
    double length(int a, int b) const { return (positions_[a] - positions_[b]).norm(); }
    double wanted(int a, int b) const { return 0.5 * (wanted_[a] + wanted_[b]); }

    bool on_border(int v) const { return line_[v] != kFreeVertex; }

    int add_vertex(const Vec3& position, int line) {
        positions_.push_back(position);
        line_.push_back(line);
        wanted_.push_back(options_.edge_length(position));
        around_.emplace_back();
        return static_cast<int>(positions_.size()) - 1;
    }

    void add_triangle(const Corners& corners) {
        const int t = static_cast<int>(triangles_.size());
        triangles_.push_back(corners);
        for (const int v : corners) {
            around_[v].push_back(t);
        }
    }

    void remove_triangle(int t) {
        for (const int v : triangles_[t]) {
            std::erase(around_[v], t);
        }
        triangles_[t] = {-1, -1, -1};
    }

    /// Triangles with the edge a-b: at most two on a manifold.
    std::vector<int> sharing(int a, int b) const {
        std::vector<int> both;
        for (const int t : around_[a]) {
            if (std::find(triangles_[t].begin(), triangles_[t].end(), b) != triangles_[t].end()) {
                both.push_back(t);
            }
        }
        return both;
    }

    int opposite(int t, int a, int b) const {
        for (const int v : triangles_[t]) {
            if (v != a && v != b) {
                return v;
            }
        }
        return -1;
    }

    int split(int a, int b) {
        const std::vector<int> both = sharing(a, b);
        // Between a line and a pinned end the line goes on.
        const int line = both.size() != 1 ? kFreeVertex : std::max(line_[a], line_[b]);
        const int middle = add_vertex(0.5 * (positions_[a] + positions_[b]), line);
        for (const int t : both) {
            Corners with_a = triangles_[t];
            Corners with_b = triangles_[t];
            std::replace(with_a.begin(), with_a.end(), b, middle);
            std::replace(with_b.begin(), with_b.end(), a, middle);
            // Reuse the slot for one half.
            std::erase(around_[b], t);
            around_[middle].push_back(t);
            triangles_[t] = with_a;
            add_triangle(with_b);
        }
        return middle;
    }

    std::vector<int> ring(int v) const {
        std::vector<int> neighbours;
        for (const int t : around_[v]) {
            for (const int w : triangles_[t]) {
                if (w != v) {
                    neighbours.push_back(w);
                }
            }
        }
        std::sort(neighbours.begin(), neighbours.end());
        neighbours.erase(std::unique(neighbours.begin(), neighbours.end()), neighbours.end());
        return neighbours;
    }

    Vec3 normal_with(int t, int from, const Vec3& moved) const {
        std::array<Vec3, 3> p;
        for (int c = 0; c < 3; ++c) {
            p[c] = triangles_[t][c] == from ? moved : positions_[triangles_[t][c]];
        }
        return (p[1] - p[0]).cross(p[2] - p[0]);
    }

    /// Moves a onto b where that keeps the surface manifold, unfolded and evenly sized.
    bool collapse(int a, int b) {
        const std::vector<int> both = sharing(a, b);
        if (both.empty() || line_[a] == kPinnedVertex ||
            (on_border(a) && (!on_border(b) || both.size() != 1))) {
            return false;
        }
        const std::vector<int> ring_a = ring(a);
        const std::vector<int> ring_b = ring(b);
        std::vector<int> shared;
        std::set_intersection(ring_a.begin(), ring_a.end(), ring_b.begin(), ring_b.end(),
                              std::back_inserter(shared));
        if (shared.size() != both.size()) {
            return false;
        }
        for (const int w : shared) {
            if (around_[w].size() <= 3 && !on_border(w)) {
                return false;
            }
        }
        for (const int w : ring_a) {
            if (w != b && length(w, b) > kSplit * wanted(w, b)) {
                return false;
            }
        }
        for (const int t : around_[a]) {
            if (std::find(both.begin(), both.end(), t) != both.end()) {
                continue;
            }
            const Vec3 before = normal_with(t, -1, positions_[a]);
            const Vec3 after = normal_with(t, a, positions_[b]);
            if (before.dot(after) < 0.5 * before.norm() * after.norm()) {
                return false;
            }
        }
        for (const int t : both) {
            remove_triangle(t);
        }
        for (const int t : std::vector<int>(around_[a])) {
            std::replace(triangles_[t].begin(), triangles_[t].end(), a, b);
            around_[b].push_back(t);
        }
        around_[a].clear();
        return true;
    }

    void flip_if_better(int a, int b) {
        const std::vector<int> both = sharing(a, b);
        if (both.size() != 2) {
            return;
        }
        const int c = opposite(both[0], a, b);
        const int d = opposite(both[1], a, b);
        if (c == d || !sharing(c, d).empty() || around_[a].size() <= 3 || around_[b].size() <= 3) {
            return;
        }
        const auto cosine = [&](int apex) {
            return (positions_[a] - positions_[apex])
                .normalized()
                .dot((positions_[b] - positions_[apex]).normalized());
        };
        const auto angle = [](double x) { return std::acos(std::clamp(x, -1.0, 1.0)); };
        if (angle(cosine(c)) + angle(cosine(d)) <= 3.1416 + 1e-3) {
            return;
        }
        Corners first = triangles_[both[0]];
        Corners second = triangles_[both[1]];
        std::replace(first.begin(), first.end(), b, d);
        std::replace(second.begin(), second.end(), a, c);
        const auto area = [&](const Corners& t) -> Vec3 {
            return (positions_[t[1]] - positions_[t[0]]).cross(positions_[t[2]] - positions_[t[0]]);
        };
        const Vec3 old_first = area(triangles_[both[0]]);
        const Vec3 old_second = area(triangles_[both[1]]);
        const Vec3 mean = (old_first + old_second).normalized();
        if (old_first.normalized().dot(old_second.normalized()) < 0.7 ||
            area(first).dot(mean) <= 0.0 || area(second).dot(mean) <= 0.0) {
            return;  // across a crease, or it would fold
        }
        for (const int t : both) {
            remove_triangle(t);
        }
        const auto put = [&](int t, const Corners& corners) {
            triangles_[t] = corners;
            for (const int v : corners) {
                around_[v].push_back(t);
            }
        };
        put(both[0], first);
        put(both[1], second);
    }

    Vec3 relaxed(int v, bool project) const {
        if (around_[v].empty() || line_[v] == kPinnedVertex) {
            return positions_[v];
        }
        Vec3 sum = Vec3::Zero();
        double weights = 0.0;
        Vec3 normal = Vec3::Zero();
        if (on_border(v)) {
            for (const int w : ring(v)) {
                if (on_border(w) && sharing(v, w).size() == 1) {
                    sum += positions_[w];
                    weights += 1.0;
                }
            }
        } else {
            for (const int t : around_[v]) {
                const Corners& c = triangles_[t];
                const Vec3 area = (positions_[c[1]] - positions_[c[0]])
                                      .cross(positions_[c[2]] - positions_[c[0]]);
                // Small triangles wanted here count for more, so that sizes stay graded.
                const double local = (wanted_[c[0]] + wanted_[c[1]] + wanted_[c[2]]) / 3.0;
                const double weight = area.norm() / (local * local);
                sum += weight * (positions_[c[0]] + positions_[c[1]] + positions_[c[2]]) / 3.0;
                weights += weight;
                normal += area;
            }
        }
        Vec3 moved = positions_[v];
        if (weights > 0.0) {
            Vec3 step = sum / weights - positions_[v];
            if (!on_border(v) && normal.norm() > 0.0) {
                normal.normalize();
                step -= step.dot(normal) * normal;
            }
            moved += 0.6 * step;
        }
        return project ? options_.project(moved, line_[v]) : moved;
    }

    const RemeshOptions& options_;
    std::vector<Vec3> positions_;
    std::vector<int> line_;
    std::vector<double> wanted_;
    std::vector<std::vector<int>> around_;
    std::vector<Corners> triangles_;
};

}  // namespace

RemeshedSurface remesh(const TriangleMesh& mesh, const RemeshOptions& options) {
    Surface surface(mesh, options);
    for (int round = 0; round < options.rounds; ++round) {
        surface.split_long_edges();
        surface.collapse_short_edges();
        surface.flip_edges();
        for (int pass = 0; pass < 3; ++pass) {
            surface.relax(pass == 2);
        }
    }
    surface.flip_edges();
    surface.relax(true);
    return surface.surface();
}

}  // namespace myoface
