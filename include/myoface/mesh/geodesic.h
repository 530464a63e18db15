// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <limits>
#include <span>
#include <vector>

#include "myoface/mesh/adjacency.h"

namespace myoface {

struct GeodesicSource {
    int vertex = 0;
    double distance = 0.0;  ///< distance already gone at this vertex [mm]
};

/// How much longer than its true length a way counts around a vertex (> 0); by default once.
using WayWeight = std::function<double(int vertex)>;

/// Shortest way over the surface from the sources to every vertex [mm]; infinity where no way of at
/// most `limit` leads. Fronts cross triangles as if from a point in their plane, so that the
/// triangulation hardly shows: exact in a plane around one source. @cite kimmel_1998
std::vector<double> geodesic_distances(const TriangleMesh& mesh, const Adjacency& adjacency,
                                       std::span<const GeodesicSource> sources,
                                       double limit = std::numeric_limits<double>::infinity(),
                                       const WayWeight& weight = {});

}  // namespace myoface
