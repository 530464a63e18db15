// SPDX-License-Identifier: Apache-2.0
#include "myoface/mesh/weld.h"

#include <algorithm>
#include <bit>
#include <cstdint>

namespace myoface {
namespace {

/// For every vertex the first one at its place.
std::vector<int> first_at_place(const Points& vertices) {
    const auto n = static_cast<std::size_t>(vertices.cols());
    std::vector<int> slots(std::bit_ceil(2 * n + 2), -1);
    std::vector<int> first(n);
    for (std::size_t v = 0; v < n; ++v) {
        const Vec3 p = vertices.col(static_cast<Eigen::Index>(v));
        std::uint64_t hash = 0;
        for (const double x : {p.x() + 0.0, p.y() + 0.0, p.z() + 0.0}) {  // -0 and 0 are one place
            hash = (hash ^ std::bit_cast<std::uint64_t>(x)) * 0x9E3779B97F4A7C15U;
            hash ^= hash >> 29;
        }
        std::size_t slot = hash & (slots.size() - 1);
        while (slots[slot] >= 0 && vertices.col(slots[slot]) != p) {
            slot = (slot + 1) & (slots.size() - 1);
        }
        if (slots[slot] < 0) {
            slots[slot] = static_cast<int>(v);
        }
        first[v] = slots[slot];
    }
    return first;
}

/// Marks triangles whose three corners an earlier one has, whatever the order.
std::vector<bool> repeated(const std::vector<Eigen::Vector3i>& triangles, std::size_t vertices) {
    // Bucket by the smallest corner; buckets are small.
    std::vector<int> start(vertices + 1, 0);
    for (const Eigen::Vector3i& t : triangles) {
        ++start[static_cast<std::size_t>(t.minCoeff()) + 1];
    }
    for (std::size_t v = 0; v < vertices; ++v) {
        start[v + 1] += start[v];
    }
    struct Entry {
        int middle, high, triangle;
    };
    std::vector<Entry> entries(triangles.size());
    std::vector<int> at(start.begin(), start.end() - 1);
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        const int low = triangles[t].minCoeff();
        const int high = triangles[t].maxCoeff();
        entries[static_cast<std::size_t>(at[static_cast<std::size_t>(low)]++)] = {
            triangles[t].sum() - low - high, high, static_cast<int>(t)};
    }
    std::vector<bool> result(triangles.size(), false);
    for (std::size_t v = 0; v < vertices; ++v) {
        const auto begin = entries.begin() + start[v];
        const auto end = entries.begin() + start[v + 1];
        std::sort(begin, end, [](const Entry& p, const Entry& q) {
            return std::tie(p.middle, p.high, p.triangle) < std::tie(q.middle, q.high, q.triangle);
        });
        for (auto entry = begin; entry != end && entry + 1 != end; ++entry) {
            if (entry->middle == (entry + 1)->middle && entry->high == (entry + 1)->high) {
                result[static_cast<std::size_t>((entry + 1)->triangle)] = true;
            }
        }
    }
    return result;
}

}  // namespace

WeldedMesh weld(const TriangleMesh& mesh) {
    const auto n = static_cast<std::size_t>(mesh.vertex_count());
    const std::vector<int> first = first_at_place(mesh.vertices);
    WeldedMesh result;
    std::vector<Eigen::Vector3i> kept;
    kept.reserve(static_cast<std::size_t>(mesh.triangle_count()));
    result.of_triangle.reserve(kept.capacity());
    for (int t = 0; t < mesh.triangle_count(); ++t) {
        const Eigen::Vector3i corners(first[mesh.triangles(0, t)], first[mesh.triangles(1, t)],
                                      first[mesh.triangles(2, t)]);
        const bool equal =
            corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0];
        if (equal || !(double_area_vector(mesh, t).squaredNorm() > 0.0)) {
            ++result.degenerate;
            continue;
        }
        kept.push_back(corners);
        result.of_triangle.push_back(t);
    }
    const std::vector<bool> again = repeated(kept, n);
    std::size_t left = 0;
    for (std::size_t t = 0; t < kept.size(); ++t) {
        if (!again[t]) {
            kept[left] = kept[t];
            result.of_triangle[left++] = result.of_triangle[t];
        }
    }
    result.duplicates = static_cast<int>(kept.size() - left);
    kept.resize(left);
    result.of_triangle.resize(left);

    std::vector<int> number(n, -1);
    for (const Eigen::Vector3i& triangle : kept) {
        for (const int v : triangle) {
            number[v] = 0;
        }
    }
    int count = 0;
    for (int& k : number) {
        k = k == 0 ? count++ : -1;
    }
    result.mesh.vertices.resize(3, count);
    result.of_vertex.resize(n);
    for (std::size_t v = 0; v < n; ++v) {
        result.of_vertex[v] = number[first[v]];
        if (number[v] >= 0) {
            result.mesh.vertices.col(number[v]) = mesh.vertices.col(static_cast<Eigen::Index>(v));
        }
    }
    result.mesh.triangles.resize(3, static_cast<Eigen::Index>(kept.size()));
    for (std::size_t t = 0; t < kept.size(); ++t) {
        for (int c = 0; c < 3; ++c) {
            result.mesh.triangles(c, static_cast<Eigen::Index>(t)) = number[kept[t][c]];
        }
    }
    return result;
}

}  // namespace myoface
