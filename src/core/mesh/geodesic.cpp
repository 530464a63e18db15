// SPDX-License-Identifier: Apache-2.0
#include "myoface/mesh/geodesic.h"

#include <algorithm>
#include <cmath>

#include <queue>

namespace myoface {
namespace {

constexpr double kUnreached = std::numeric_limits<double>::infinity();

/// Distance at the third corner of a triangle, of a front that comes through the side between two
/// corners where the distances are known; infinity where it does not come through there.
/// @param side length of that side @param first, second of the others, from each of its ends
double across(double side, double first, double second, double at_first, double at_second) {
    if (!(side > 0.0)) {
        return kUnreached;
    }
    const double x = (first * first - second * second + side * side) / (2.0 * side);
    const double y = std::sqrt(std::max(0.0, first * first - x * x));
    // The point behind the side that is as far from both ends as they say.
    const double source_x =
        (at_first * at_first - at_second * at_second + side * side) / (2.0 * side);
    const double square = at_first * at_first - source_x * source_x;
    // A source on the side itself has a square of nothing, give or take what rounding leaves.
    constexpr double kRounding = 1e-6;
    if (square < -kRounding * side * side || !(y > 0.0)) {
        return kUnreached;
    }
    const double source_y = std::sqrt(std::max(0.0, square));
    const double through = source_x + (x - source_x) * source_y / (y + source_y);
    return through >= 0.0 && through <= side ? std::hypot(x - source_x, y + source_y) : kUnreached;
}

}  // namespace

std::vector<double> geodesic_distances(const TriangleMesh& mesh, const Adjacency& adjacency,
                                       std::span<const GeodesicSource> sources, double limit,
                                       const WayWeight& weight) {
    std::vector<double> distance(static_cast<std::size_t>(mesh.vertex_count()), kUnreached);
    using Entry = std::pair<double, int>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> front;
    const auto reach = [&](int v, double gone) {
        if (gone < distance[static_cast<std::size_t>(v)] && gone <= limit) {
            distance[static_cast<std::size_t>(v)] = gone;
            front.emplace(gone, v);
        }
    };
    for (const GeodesicSource& source : sources) {
        reach(source.vertex, source.distance);
    }
    const auto counted = [&](int a, int b, double factor) {
        return factor * (mesh.vertices.col(a) - mesh.vertices.col(b)).norm();
    };
    while (!front.empty()) {
        const auto [gone, v] = front.top();
        front.pop();
        if (gone > distance[static_cast<std::size_t>(v)]) {
            continue;
        }
        for (const int t : adjacency.triangles(v)) {
            const auto corners = mesh.triangles.col(t);
            const int k = corners[0] == v ? 0 : corners[1] == v ? 1 : 2;
            const int a = corners[(k + 1) % 3];
            const int b = corners[(k + 2) % 3];
            const double factor = weight ? (weight(v) + weight(a) + weight(b)) / 3.0 : 1.0;
            const double va = counted(v, a, factor);
            const double vb = counted(v, b, factor);
            reach(a, gone + va);
            reach(b, gone + vb);
            const double ab = counted(a, b, factor);
            reach(b, across(va, vb, ab, gone, distance[static_cast<std::size_t>(a)]));
            reach(a, across(vb, va, ab, gone, distance[static_cast<std::size_t>(b)]));
        }
    }
    return distance;
}

}  // namespace myoface
