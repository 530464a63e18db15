// SPDX-License-Identifier: Apache-2.0
#include "mesh_quality.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <unordered_map>

#include <Eigen/Geometry>

namespace myoface::test {
namespace {

bool segment_crosses(const Vec3& p, const Vec3& q, const Vec3& a, const Vec3& b, const Vec3& c,
                     double tolerance) {
    const Vec3 normal = (b - a).cross(c - a).normalized();
    const double from = normal.dot(p - a);
    const double to = normal.dot(q - a);
    if (std::abs(from) < tolerance || std::abs(to) < tolerance || from * to > 0.0) {
        return false;
    }
    const Vec3 x = p + from / (from - to) * (q - p);
    const double area = normal.dot((b - a).cross(c - a));
    const double u = normal.dot((b - x).cross(c - x)) / area;
    const double v = normal.dot((c - x).cross(a - x)) / area;
    constexpr double kInside = 1e-9;
    return u > kInside && v > kInside && u + v < 1.0 - kInside;
}

bool cross(const TriangleMesh& mesh, int s, int t, double tolerance) {
    for (int i = 0; i < 3; ++i) {
        if (segment_crosses(mesh.corner(s, i), mesh.corner(s, (i + 1) % 3), mesh.corner(t, 0),
                            mesh.corner(t, 1), mesh.corner(t, 2), tolerance) ||
            segment_crosses(mesh.corner(t, i), mesh.corner(t, (i + 1) % 3), mesh.corner(s, 0),
                            mesh.corner(s, 1), mesh.corner(s, 2), tolerance)) {
            return true;
        }
    }
    return false;
}

Eigen::AlignedBox3d box_of(const TriangleMesh& mesh, int t) {
    Eigen::AlignedBox3d box;
    for (int c = 0; c < 3; ++c) {
        box.extend(Vec3(mesh.corner(t, c)));
    }
    return box;
}

}  // namespace

double smallest_angle(const TriangleMesh& mesh, int triangle) {
    double smallest = 180.0;
    for (int c = 0; c < 3; ++c) {
        const Vec3 u = mesh.corner(triangle, (c + 1) % 3) - mesh.corner(triangle, c);
        const Vec3 v = mesh.corner(triangle, (c + 2) % 3) - mesh.corner(triangle, c);
        smallest =
            std::min(smallest, std::atan2(u.cross(v).norm(), u.dot(v)) * 180.0 / std::numbers::pi);
    }
    return smallest;
}

std::vector<std::pair<int, int>> crossing_triangles(const TriangleMesh& mesh, double tolerance) {
    constexpr double kCell = 3.0;
    std::unordered_map<long long, std::vector<int>> cells;
    const auto key = [](const Eigen::Vector3i& c) {
        return (static_cast<long long>(c.x()) + 4096) * 8192 * 8192 +
               (static_cast<long long>(c.y()) + 4096) * 8192 + c.z() + 4096;
    };
    const auto cell = [&](const Vec3& p) {
        return Eigen::Vector3i((p / kCell).array().floor().cast<int>().matrix());
    };
    for (int t = 0; t < mesh.triangle_count(); ++t) {
        const Eigen::AlignedBox3d box = box_of(mesh, t);
        const Eigen::Vector3i low = cell(box.min());
        const Eigen::Vector3i high = cell(box.max());
        for (int x = low.x(); x <= high.x(); ++x) {
            for (int y = low.y(); y <= high.y(); ++y) {
                for (int z = low.z(); z <= high.z(); ++z) {
                    cells[key({x, y, z})].push_back(t);
                }
            }
        }
    }
    std::vector<std::pair<int, int>> found;
    for (const auto& [at, list] : cells) {
        for (std::size_t i = 0; i < list.size(); ++i) {
            const Eigen::AlignedBox3d box = box_of(mesh, list[i]);
            for (std::size_t j = i + 1; j < list.size(); ++j) {
                bool shared = false;
                for (int a = 0; a < 3; ++a) {
                    for (int b = 0; b < 3; ++b) {
                        shared = shared || mesh.triangles(a, list[i]) == mesh.triangles(b, list[j]);
                    }
                }
                if (!shared && box.intersects(box_of(mesh, list[j])) &&
                    cross(mesh, list[i], list[j], tolerance)) {
                    found.emplace_back(std::min(list[i], list[j]), std::max(list[i], list[j]));
                }
            }
        }
    }
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
}

}  // namespace myoface::test
