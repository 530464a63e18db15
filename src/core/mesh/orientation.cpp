// SPDX-License-Identifier: Apache-2.0
#include "myoface/mesh/orientation.h"

#include <array>
#include <cmath>

namespace myoface {
namespace {

/// Triangles that hang together across edges with exactly two triangles.
struct Sheet {
    std::vector<int> triangles;
    double area = 0.0;
};

/// Whether a triangle runs along its edge from the lower to the higher vertex.
bool runs_up(const TriangleMesh& mesh, int triangle, const MeshEdge& edge) {
    for (int c = 0; c < 3; ++c) {
        if (mesh.triangles(c, triangle) == edge.vertices[0]) {
            return mesh.triangles((c + 1) % 3, triangle) == edge.vertices[1];
        }
    }
    return false;
}

/// Six times the volume under the sheet, seen from its middle.
double volume_about_middle(const TriangleMesh& mesh, const Sheet& sheet,
                           const std::vector<bool>& turn) {
    Vec3 middle = Vec3::Zero();
    double weight = 0.0;
    for (const int t : sheet.triangles) {
        const double area = double_area_vector(mesh, t).norm();
        middle += area / 3.0 * (mesh.corner(t, 0) + mesh.corner(t, 1) + mesh.corner(t, 2));
        weight += area;
    }
    middle /= weight > 0.0 ? weight : 1.0;
    double volume = 0.0;
    for (const int t : sheet.triangles) {
        const double part = (mesh.corner(t, 0) - middle).dot(double_area_vector(mesh, t));
        volume += turn[static_cast<std::size_t>(t)] ? -part : part;
    }
    return volume;
}

}  // namespace

Orientation outward_orientation(const TriangleMesh& mesh, const Adjacency& adjacency) {
    const auto triangles = static_cast<std::size_t>(mesh.triangle_count());
    Orientation result;
    result.turn.assign(triangles, false);
    // Neighbours per triangle with whether they agree.
    std::vector<std::array<int, 3>> across(triangles, {-1, -1, -1});
    std::vector<std::array<bool, 3>> agrees(triangles);
    std::vector<int> degree(triangles, 0);
    for (const MeshEdge& edge : adjacency.edges()) {
        if (edge.triangle_count != 2) {
            continue;
        }
        const auto [a, b] = edge.triangles;
        const bool agree = runs_up(mesh, a, edge) != runs_up(mesh, b, edge);
        for (const auto& [one, other] : {std::pair(a, b), std::pair(b, a)}) {
            const auto t = static_cast<std::size_t>(one);
            const auto slot = static_cast<std::size_t>(degree[t]++);
            across[t][slot] = other;
            agrees[t][slot] = agree;
        }
    }
    std::vector<Sheet> sheets;
    std::vector<bool> seen(triangles, false);
    for (std::size_t first = 0; first < triangles; ++first) {
        if (seen[first]) {
            continue;
        }
        Sheet sheet;
        seen[first] = true;
        sheet.triangles.push_back(static_cast<int>(first));
        double turned_area = 0.0;
        for (std::size_t k = 0; k < sheet.triangles.size(); ++k) {
            const auto t = static_cast<std::size_t>(sheet.triangles[k]);
            const double area = double_area_vector(mesh, sheet.triangles[k]).norm();
            sheet.area += area;
            turned_area += result.turn[t] ? area : 0.0;
            for (std::size_t slot = 0; slot < static_cast<std::size_t>(degree[t]); ++slot) {
                const auto next = static_cast<std::size_t>(across[t][slot]);
                if (!seen[next]) {
                    seen[next] = true;
                    result.turn[next] = result.turn[t] == agrees[t][slot];
                    sheet.triangles.push_back(static_cast<int>(next));
                }
            }
        }
        if (2.0 * turned_area > sheet.area) {
            for (const int t : sheet.triangles) {
                result.turn[static_cast<std::size_t>(t)].flip();
            }
        }
        for (const int t : sheet.triangles) {
            result.disagreeing += result.turn[static_cast<std::size_t>(t)] ? 1 : 0;
        }
        sheets.push_back(std::move(sheet));
    }
    std::size_t largest = 0;
    for (std::size_t s = 1; s < sheets.size(); ++s) {
        largest = sheets[s].area > sheets[largest].area ? s : largest;
    }
    if (sheets.empty() || volume_about_middle(mesh, sheets[largest], result.turn) >= 0.0) {
        return result;
    }
    result.inward = true;
    for (const Sheet& sheet : sheets) {
        if (&sheet == &sheets[largest] || volume_about_middle(mesh, sheet, result.turn) < 0.0) {
            for (const int t : sheet.triangles) {
                result.turn[static_cast<std::size_t>(t)].flip();
            }
        }
    }
    return result;
}

}  // namespace myoface
