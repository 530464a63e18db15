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

/// How much longer than its true length an edge counts (≥ 0); by default every edge counts once.
using EdgeWeight = std::function<double(int from, int to)>;

/// Shortest way along edges from the sources to every vertex [mm]; infinity where no way of at most
/// `limit` leads. Along edges it is up to about 10 % longer than across triangles.
std::vector<double> geodesic_distances(const Points& vertices, const Adjacency& adjacency,
                                       std::span<const GeodesicSource> sources,
                                       double limit = std::numeric_limits<double>::infinity(),
                                       const EdgeWeight& weight = {});

}  // namespace myoface
