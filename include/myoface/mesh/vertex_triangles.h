// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "myoface/mesh/triangle_mesh.h"

namespace myoface {

/// The triangles at each vertex, in compressed rows: all that is needed of a very fine mesh, at a
/// tenth of the memory that Adjacency takes.
class VertexTriangles {
public:
    VertexTriangles() = default;
    explicit VertexTriangles(const TriangleMesh& mesh);

    /// Triangles that touch a vertex, ascending.
    std::span<const int> at(int vertex) const {
        const auto v = static_cast<std::size_t>(vertex);
        return {triangle_.data() + start_[v], static_cast<std::size_t>(start_[v + 1] - start_[v])};
    }

private:
    std::vector<int> start_, triangle_;
};

}  // namespace myoface
