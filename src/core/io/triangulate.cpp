// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "myoface/io/scan.h"

namespace myoface {
namespace {

/// Newell's normal: right for concave and slightly bent faces.
Vec3 face_normal(const Points& vertices, const std::vector<int>& corners) {
    Vec3 normal = Vec3::Zero();
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Vec3 a = vertices.col(corners[i]);
        const Vec3 b = vertices.col(corners[(i + 1) % corners.size()]);
        normal += a.cross(b);
    }
    return normal;
}

/// Corner positions, as numbers 0 … n-1, of the triangles of one face.
std::vector<std::array<int, 3>> clip_ears(const Points& vertices, const std::vector<int>& corners) {
    const Vec3 normal = face_normal(vertices, corners);
    const auto at = [&](int k) -> Vec3 { return vertices.col(corners[k]); };
    const auto turn = [&](int a, int b, int c) {
        return (at(b) - at(a)).cross(at(c) - at(a)).dot(normal);
    };
    std::vector<int> left(corners.size());
    for (std::size_t i = 0; i < left.size(); ++i) {
        left[i] = static_cast<int>(i);
    }
    std::vector<std::array<int, 3>> triangles;
    while (left.size() > 3) {
        const std::size_t n = left.size();
        std::size_t best = n;
        double best_shape = -1.0;
        for (std::size_t i = 0; i < n; ++i) {
            const int a = left[(i + n - 1) % n];
            const int b = left[i];
            const int c = left[(i + 1) % n];
            if (turn(a, b, c) <= 0.0) {
                continue;
            }
            const bool holds_another = std::any_of(left.begin(), left.end(), [&](int k) {
                return k != a && k != b && k != c && turn(a, b, k) > 0.0 && turn(b, c, k) > 0.0 &&
                       turn(c, a, k) > 0.0;
            });
            const double longest =
                std::max({(at(a) - at(b)).squaredNorm(), (at(b) - at(c)).squaredNorm(),
                          (at(c) - at(a)).squaredNorm()});
            const double shape = longest > 0.0 ? 1.0 / longest : 0.0;
            if (!holds_another && shape > best_shape) {
                best = i;
                best_shape = shape;
            }
        }
        if (best == n) {
            best = 1;  // crossed or flat: any fan is as good as another
        }
        triangles.push_back({left[(best + n - 1) % n], left[best], left[(best + 1) % n]});
        left.erase(left.begin() + static_cast<std::ptrdiff_t>(best));
    }
    triangles.push_back({left[0], left[1], left[2]});
    return triangles;
}

}  // namespace

void triangulate(Scan& scan) {
    const Polygons& faces = scan.faces;
    std::vector<Eigen::Vector3i> triangles;
    scan.triangle_face.clear();
    scan.triangle_corner.clear();
    std::vector<int> corners;
    for (int f = 0; f < faces.count(); ++f) {
        const int begin = faces.start[f];
        const auto add = [&](int a, int b, int c) {
            triangles.emplace_back(faces.vertex[begin + a], faces.vertex[begin + b],
                                   faces.vertex[begin + c]);
            scan.triangle_face.push_back(f);
            scan.triangle_corner.push_back({begin + a, begin + b, begin + c});
        };
        if (faces.size(f) == 3) {
            add(0, 1, 2);
            continue;
        }
        corners.assign(faces.vertex.begin() + begin, faces.vertex.begin() + faces.start[f + 1]);
        for (const auto& t : clip_ears(scan.mesh.vertices, corners)) {
            add(t[0], t[1], t[2]);
        }
    }
    scan.mesh.triangles.resize(3, static_cast<Eigen::Index>(triangles.size()));
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        scan.mesh.triangles.col(static_cast<Eigen::Index>(t)) = triangles[t];
    }
}

void set_frame(Scan& scan, const FileFrame& frame) {
    const Mat3 change =
        frame.mm_per_unit / scan.frame.mm_per_unit * frame.axes * scan.frame.axes.transpose();
    scan.mesh.vertices = (change * scan.mesh.vertices).eval();
    scan.frame = frame;
}

}  // namespace myoface
