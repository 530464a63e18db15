// SPDX-License-Identifier: Apache-2.0
#include "lip_sides.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "myoface/mesh/adjacency.h"

#include "point_tree.h"

namespace myoface {
namespace {

/// Marks with `mark` the vertices within two edges of one, or within a way along edges.
void mark_around(const TriangleMesh& mesh, const Adjacency& adjacency, int vertex, double way,
                 std::vector<int>& marks, int mark) {
    struct Reached {
        int vertex, edges;
        double away;
    };
    std::vector<Reached> reached{{vertex, 0, 0.0}};
    marks[static_cast<std::size_t>(vertex)] = mark;
    for (std::size_t k = 0; k < reached.size(); ++k) {
        const Reached from = reached[k];
        for (const int w : adjacency.neighbours(from.vertex)) {
            const double there =
                from.away + (mesh.vertices.col(w) - mesh.vertices.col(from.vertex)).norm();
            if ((from.edges < 2 || there <= way) && marks[static_cast<std::size_t>(w)] != mark) {
                marks[static_cast<std::size_t>(w)] = mark;
                reached.push_back({w, from.edges + 1, there});
            }
        }
    }
}

}  // namespace

std::vector<std::pair<int, int>> find_lip_contacts(const TriangleMesh& lips,
                                                   const Points& generic) {
    constexpr double kTouching = 0.6;   // [mm]
    constexpr double kSameSheet = 2.0;  // [mm] along the skin: neighbours are not two lips
    constexpr std::size_t kTried = 8;
    const Adjacency adjacency(lips);
    std::vector<int> upper;
    std::vector<int> lower;
    for (int v = 0; v < lips.vertex_count(); ++v) {
        const Vec3 p = generic.col(v);
        const auto neighbours = adjacency.neighbours(v);
        if (std::abs(p.x()) > 24.0 || std::abs(p.y() + 52.0) > 9.0 || p.z() < 70.0 ||
            neighbours.empty()) {
            continue;
        }
        double height = 0.0;
        for (const int w : neighbours) {
            height += generic(1, w);
        }
        height /= static_cast<double>(neighbours.size());
        (height > p.y() ? upper : lower).push_back(v);
    }
    std::vector<std::pair<int, int>> pairs;
    if (upper.empty() || lower.empty()) {
        return pairs;
    }
    const Points places = lips.vertices(Eigen::all, lower);
    const PointTree<3> tree(places);
    std::vector<int> marks(static_cast<std::size_t>(lips.vertex_count()), -1);
    for (const int u : upper) {
        std::array<std::uint32_t, kTried> found{};
        std::array<double, kTried> square{};
        const Vec3 at = lips.vertices.col(u);
        const std::size_t count = tree.nearest(at.data(), kTried, found.data(), square.data());
        if (count == 0 || square[0] > kTouching * kTouching) {
            continue;
        }
        mark_around(lips, adjacency, u, kSameSheet, marks, u);
        for (std::size_t k = 0; k < count && square[k] <= kTouching * kTouching; ++k) {
            const int l = lower[found[k]];
            if (marks[static_cast<std::size_t>(l)] != u) {
                pairs.emplace_back(u, l);
                break;
            }
        }
    }
    return pairs;
}

std::vector<signed char> find_lip_sides(const FaceModel& face) {
    std::vector<signed char> side = face.lip_side;  // what is known where lips were parted
    side.resize(static_cast<std::size_t>(face.node_count()), 0);
    if (face.lip_contacts.empty()) {
        return side;
    }
    constexpr double kSure = 3.0;  // [mm] above or below the line where the lips meet
    std::vector<char> mouth(side.size(), 0);
    std::vector<int> reached;
    for (int v = 0; v < face.node_count(); ++v) {
        const Vec3 p = face.generic.col(v);
        if (std::abs(p.x()) > 34.0 || std::abs(p.y() + 52.0) > 26.0 || p.z() < 35.0) {
            continue;
        }
        mouth[v] = 1;
        const double upper = upper_lip_share({0.0, p.y(), p.z()}, kSure);
        if (side[v] == 0 && (upper >= 1.0 || upper <= 0.0)) {
            side[v] = upper >= 1.0 ? 1 : -1;
        }
        if (side[v] != 0) {
            reached.push_back(v);
        }
    }
    // Breadth first from the sure ones.
    for (std::size_t next = 0; next < reached.size(); ++next) {
        for (const int w : face.adjacency->neighbours(reached[next])) {
            if (mouth[w] != 0 && side[w] == 0) {
                side[w] = side[reached[next]];
                reached.push_back(w);
            }
        }
    }
    return side;
}

}  // namespace myoface
