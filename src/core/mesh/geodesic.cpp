// SPDX-License-Identifier: Apache-2.0
#include "myoface/mesh/geodesic.h"

#include <queue>

namespace myoface {

std::vector<double> geodesic_distances(const Points& vertices, const Adjacency& adjacency,
                                       std::span<const GeodesicSource> sources, double limit,
                                       const EdgeWeight& weight) {
    constexpr double kFar = std::numeric_limits<double>::infinity();
    std::vector<double> distance(static_cast<std::size_t>(vertices.cols()), kFar);
    using Entry = std::pair<double, int>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> front;
    for (const GeodesicSource& source : sources) {
        if (source.distance < distance[source.vertex]) {
            distance[source.vertex] = source.distance;
            front.emplace(source.distance, source.vertex);
        }
    }
    while (!front.empty()) {
        const auto [gone, v] = front.top();
        front.pop();
        if (gone > distance[v]) {
            continue;
        }
        for (const int w : adjacency.neighbours(v)) {
            const double step = (vertices.col(v) - vertices.col(w)).norm();
            const double reached = gone + (weight ? weight(v, w) : 1.0) * step;
            if (reached < distance[w] && reached <= limit) {
                distance[w] = reached;
                front.emplace(reached, w);
            }
        }
    }
    return distance;
}

}  // namespace myoface
