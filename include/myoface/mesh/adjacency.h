// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <span>
#include <vector>

#include "myoface/mesh/triangle_mesh.h"

namespace myoface {

/// An undirected edge, its one or two triangles and the vertices opposite to it in them.
struct MeshEdge {
    std::array<int, 2> vertices{};         ///< in ascending order
    std::array<int, 2> triangles{-1, -1};  ///< the second is -1 on the border
    std::array<int, 2> opposite{-1, -1};   ///< vertex across the edge in each triangle
    int triangle_count = 0;                ///< more than 2: the edge is not manifold
};

/// Who touches whom in a mesh, in compressed rows. Built once, never changed.
class Adjacency {
public:
    explicit Adjacency(const TriangleMesh& mesh);

    /// Edges, sorted by their vertices.
    const std::vector<MeshEdge>& edges() const { return edges_; }
    /// Neighbours of a vertex along edges, ascending.
    std::span<const int> neighbours(int vertex) const;
    /// Triangles that touch a vertex, ascending.
    std::span<const int> triangles(int vertex) const;
    int vertex_count() const { return static_cast<int>(neighbour_start_.size()) - 1; }

private:
    std::vector<MeshEdge> edges_;
    std::vector<int> neighbour_start_, neighbours_;
    std::vector<int> triangle_start_, triangles_;
};

/// Border loops: closed runs of edges that have one triangle, each as a list of vertices, the
/// longest (in millimetres) first. A vertex that two loops share appears in both.
std::vector<std::vector<int>> boundary_loops(const TriangleMesh& mesh, const Adjacency& adjacency);

/// Connected parts: a part number per vertex (isolated vertices are parts of their own) and their
/// count. Parts are numbered by their smallest vertex.
struct Components {
    std::vector<int> of_vertex;
    int count = 0;
};
Components connected_components(const TriangleMesh& mesh);

}  // namespace myoface
