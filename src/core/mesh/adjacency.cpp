// SPDX-License-Identifier: Apache-2.0
#include "myoface/mesh/adjacency.h"

#include <algorithm>
#include <numeric>

#include "myoface/base/parallel.h"

namespace myoface {
namespace {

struct HalfEdge {
    int low, high, triangle, opposite;
};

/// Half edges by their lower, then their higher vertex, then their triangle.
std::vector<HalfEdge> sorted_half_edges(const TriangleMesh& mesh) {
    const int n = mesh.vertex_count();
    std::vector<int> start(static_cast<std::size_t>(n) + 1, 0);
    for (int t = 0; t < mesh.triangle_count(); ++t) {
        for (int c = 0; c < 3; ++c) {
            ++start[std::min(mesh.triangles(c, t), mesh.triangles((c + 1) % 3, t)) + 1];
        }
    }
    std::partial_sum(start.begin(), start.end(), start.begin());
    std::vector<HalfEdge> halves(static_cast<std::size_t>(start.back()));
    std::vector<int> at(start.begin(), start.end() - 1);
    for (int t = 0; t < mesh.triangle_count(); ++t) {
        for (int c = 0; c < 3; ++c) {
            const int a = mesh.triangles(c, t);
            const int b = mesh.triangles((c + 1) % 3, t);
            halves[static_cast<std::size_t>(at[std::min(a, b)]++)] = {
                std::min(a, b), std::max(a, b), t, mesh.triangles((c + 2) % 3, t)};
        }
    }
    parallel_for(n, 8192, [&](int begin, int end) {
        for (int v = begin; v < end; ++v) {
            std::sort(halves.begin() + start[v], halves.begin() + start[v + 1],
                      [](const HalfEdge& p, const HalfEdge& q) {
                          return std::tie(p.high, p.triangle) < std::tie(q.high, q.triangle);
                      });
        }
    });
    return halves;
}

/// Turns (row, value) pairs, given by a visitor run twice, into compressed rows.
template <typename Visit>
void fill_rows(int rows, std::vector<int>& start, std::vector<int>& values, const Visit& visit) {
    start.assign(static_cast<std::size_t>(rows) + 1, 0);
    visit([&](int row, int) { ++start[row + 1]; });
    std::partial_sum(start.begin(), start.end(), start.begin());
    values.resize(static_cast<std::size_t>(start.back()));
    std::vector<int> at(start.begin(), start.end() - 1);
    visit([&](int row, int value) { values[at[row]++] = value; });
}

}  // namespace

Adjacency::Adjacency(const TriangleMesh& mesh) {
    edges_.reserve(3 * static_cast<std::size_t>(mesh.triangle_count()) / 2 + 16);
    for (const HalfEdge& half : sorted_half_edges(mesh)) {
        if (half.low == half.high) {
            continue;  // a degenerate triangle has no edge here
        }
        if (edges_.empty() || edges_.back().vertices != std::array{half.low, half.high}) {
            edges_.push_back({});
            edges_.back().vertices = {half.low, half.high};
        }
        MeshEdge& edge = edges_.back();
        if (edge.triangle_count < 2) {
            edge.triangles[edge.triangle_count] = half.triangle;
            edge.opposite[edge.triangle_count] = half.opposite;
        }
        ++edge.triangle_count;
    }
    const int n = mesh.vertex_count();
    fill_rows(n, neighbour_start_, neighbours_, [&](auto&& add) {
        for (const MeshEdge& edge : edges_) {
            add(edge.vertices[0], edge.vertices[1]);
            add(edge.vertices[1], edge.vertices[0]);
        }
    });
    for (int v = 0; v < n; ++v) {
        std::sort(neighbours_.begin() + neighbour_start_[v],
                  neighbours_.begin() + neighbour_start_[v + 1]);
    }
    fill_rows(n, triangle_start_, triangles_, [&](auto&& add) {
        for (int t = 0; t < mesh.triangle_count(); ++t) {
            for (int c = 0; c < 3; ++c) {
                add(mesh.triangles(c, t), t);
            }
        }
    });
}

std::span<const int> Adjacency::neighbours(int vertex) const {
    return {neighbours_.data() + neighbour_start_[vertex],
            neighbours_.data() + neighbour_start_[vertex + 1]};
}

std::span<const int> Adjacency::triangles(int vertex) const {
    return {triangles_.data() + triangle_start_[vertex],
            triangles_.data() + triangle_start_[vertex + 1]};
}

std::vector<std::vector<int>> boundary_loops(const TriangleMesh& mesh, const Adjacency& adjacency) {
    // Directed border edges in the sense of their triangle; a loop follows them backwards, so that
    // it runs as the missing face would.
    std::vector<std::vector<int>> successors(static_cast<std::size_t>(mesh.vertex_count()));
    std::vector<int> starts;
    for (const MeshEdge& edge : adjacency.edges()) {
        if (edge.triangle_count != 1) {
            continue;
        }
        auto [a, b] = edge.vertices;
        const auto corners = mesh.triangles.col(edge.triangles[0]);
        for (int c = 0; c < 3; ++c) {
            if (corners[c] == b && corners[(c + 1) % 3] == a) {
                std::swap(a, b);
                break;
            }
        }
        successors[b].push_back(a);
        starts.push_back(b);
    }
    std::vector<std::vector<int>> loops;
    for (const int start : starts) {
        while (!successors[start].empty()) {
            std::vector<int> loop;
            int at = start;
            do {
                loop.push_back(at);
                const int next = successors[at].back();
                successors[at].pop_back();
                at = next;
            } while (at != start && !successors[at].empty());
            loops.push_back(std::move(loop));
        }
    }
    const auto length = [&](const std::vector<int>& loop) {
        double sum = 0.0;
        for (std::size_t i = 0; i < loop.size(); ++i) {
            sum += (mesh.vertices.col(loop[i]) - mesh.vertices.col(loop[(i + 1) % loop.size()]))
                       .norm();
        }
        return sum;
    };
    std::stable_sort(loops.begin(), loops.end(),
                     [&](const auto& p, const auto& q) { return length(p) > length(q); });
    return loops;
}

Components connected_components(const TriangleMesh& mesh) {
    const int n = mesh.vertex_count();
    std::vector<int> parent(static_cast<std::size_t>(n));
    std::iota(parent.begin(), parent.end(), 0);
    const auto root = [&](int v) {
        while (parent[v] != v) {
            parent[v] = parent[parent[v]];
            v = parent[v];
        }
        return v;
    };
    for (int t = 0; t < mesh.triangle_count(); ++t) {
        for (int c = 1; c < 3; ++c) {
            const int a = root(mesh.triangles(0, t));
            const int b = root(mesh.triangles(c, t));
            parent[std::max(a, b)] = std::min(a, b);
        }
    }
    Components parts;
    parts.of_vertex.assign(static_cast<std::size_t>(n), -1);
    for (int v = 0; v < n; ++v) {
        const int r = root(v);  // never larger than v, so it is numbered already
        parts.of_vertex[v] = r == v ? parts.count++ : parts.of_vertex[r];
    }
    return parts;
}

}  // namespace myoface
